// A table in the format that a file's name asks for.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "io/samples/samples.h"

namespace brdf::io {

// Throws InputError where no format of tables is written under this name: .csv, .binary (MERL), .exr, .astm
// (ASTM E1392), .zemax (lens-design text).
void check_table_format(const std::filesystem::path& path);

// Writes it. Returns what is lost, one phrase each. Throws as check_table_format and the formats' own
// writers.
std::vector<std::string> write_table(const std::filesystem::path& path, const SampleTable& table);

}  // namespace brdf::io
