#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "io/samples.h"

namespace brdf::io {

// Writes a table as an OpenEXR image of 32-bit floats: one pixel per row, 1024 to a line (the rest of the
// last line is NaN), one channel per column under its CSV name, the header's comments as string attributes.
// Returns what is lost.
std::vector<std::string> write_exr_table(const std::filesystem::path& path, const SampleTable& table);

}  // namespace brdf::io
