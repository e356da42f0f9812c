// Reads and writes tables of text columns (CSV).
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string_view>

#include "io/columns/supplied.h"
#include "io/files/content.h"
#include "io/samples/samples.h"

namespace brdf::io {

// Reads a table. `need_values`: refuse a table that has directions only. Throws InputError, which names the
// file and, if known, the line, if the table cannot be read.
SampleTable read_csv(const Content& text, bool need_values, const Supplied& supplied);

// Writes CSV that reads back to exactly the same table (shortest decimals that round-trip). Throws
// InputError if the table breaks a rule of the format. `quantity`: the quantity of the values, if other
// than f_r: f_r*cos_i or f_r*cos_o.
// Example:
//     // #include "brdf/io/formats/read.h"
//     brdf::io::SampleTable table = brdf::io::read_samples("paint.binary");
//     table.add_comment("sample", "red paint");
//     brdf::io::write_samples("paint from merl.csv", table);
void write_samples(const std::filesystem::path& path, const SampleTable& table,
                   std::string_view quantity = "f_r", Origin origin = Origin::measured);
void write_samples(std::ostream& out, const SampleTable& table, std::string_view quantity = "f_r",
                   Origin origin = Origin::measured);

}  // namespace brdf::io
