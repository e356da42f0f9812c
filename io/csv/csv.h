// Tables of columns of text.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string_view>

#include "io/columns/supplied.h"
#include "io/files/content.h"
#include "io/samples/samples.h"

namespace brdf::io {

// `need_values` refuses a table of mere directions.
SampleTable read_csv(const Content& text, bool need_values, const Supplied& supplied);

// Writes CSV that reads back to exactly the same table (shortest decimals that round-trip). Throws InputError
// where the table breaks a rule of the format. `quantity` is what the values are, if not f_r: f_r*cos_i or
// f_r*cos_o.
void write_samples(const std::filesystem::path& path, const SampleTable& table,
                   std::string_view quantity = "f_r", Origin origin = Origin::measured);
void write_samples(std::ostream& out, const SampleTable& table, std::string_view quantity = "f_r",
                   Origin origin = Origin::measured);

}  // namespace brdf::io
