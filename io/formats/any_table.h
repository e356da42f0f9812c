// Writes a table in the format that the suffix of the file's name selects.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "io/samples/samples.h"

namespace brdf::io {

// Checks the suffix of `path`. Throws InputError if no table format is written under this suffix; the known
// suffixes are .csv, .binary (MERL), .exr, .astm (ASTM E1392), .zemax (lens-design text), .xompt
// (OpenMATERIAL), .brdf (BiRD) and .xml (Klems matrices).
void check_table_format(const std::filesystem::path& path);

// Writes `table` to `path`. Returns the losses of the format, one phrase each. Throws the errors of
// check_table_format() and of the formats' own writers.
std::vector<std::string> write_table(const std::filesystem::path& path, const SampleTable& table);

}  // namespace brdf::io
