// Converts values of other quantities to f_r.
#pragma once

#include <vector>

#include "io/columns/quantities.h"
#include "io/samples/samples.h"

namespace brdf::io {

// Converts the values and standard deviations of each channel to f_r. `quantities`: the quantity of each
// channel. Rows in which a cosine of the divisor is 0 are removed and counted. Polar angles may still be
// negative. Throws InputError if no row is left, or if a value exceeds the range of double.
void make_f_r(SampleTable& table, const std::vector<Quantity>& quantities);

// Keeps the rows with these ascending numbers and removes all others.
void keep_rows(SampleTable& table, const std::vector<std::size_t>& rows);

}  // namespace brdf::io
