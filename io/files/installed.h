// Finds the data files that were installed with the program, the library or the Python module.
#pragma once

#include <filesystem>
#include <string_view>

namespace brdf::io {

// Returns the path of a file installed under the data folder of the prefix (share/), for example
// "brdf/chart.min.js". The prefix is the installation prefix of the running program, or of the library or
// Python module that contains this function, so that an installation can be moved. Returns an empty path if
// the file does not exist.
std::filesystem::path installed_file(std::string_view name);

// Returns `file` if it exists or is absolute. Otherwise returns the file of this name in the installed data
// (share/brdf) if there is one. Otherwise returns `file` unchanged, so that opening it reports that the
// file is missing.
std::filesystem::path here_or_installed(const std::filesystem::path& file);

}  // namespace brdf::io
