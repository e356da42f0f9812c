// Values of another quantity as f_r.
#pragma once

#include <vector>

#include "io/columns/quantities.h"
#include "io/samples/samples.h"

namespace brdf::io {

// Makes f_r of the values and standard deviations of each channel, whose quantities these are. Rows in which
// a cosine that is divided by is 0 are left out and counted. Polar angles may be negative still. Throws
// InputError if a value becomes larger than numbers are.
void make_f_r(SampleTable& table, const std::vector<Quantity>& quantities);

// Keeps the rows with these numbers, ascending.
void keep_rows(SampleTable& table, const std::vector<std::size_t>& rows);

}  // namespace brdf::io
