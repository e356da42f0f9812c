#pragma once

#include <filesystem>
#include <string_view>

namespace brdf::io {

// The path of a file that was installed under the data folder of the prefix (share/), for instance
// "brdf/chart.min.js". The prefix is the one that the running program, or the library or Python module that
// holds this function, lies in: it may be moved. Empty where there is no such file.
std::filesystem::path installed_file(std::string_view name);

// The file itself where it exists; else the one of this name among the installed data (share/brdf); else as
// given, so that whoever opens it says that it is missing.
std::filesystem::path here_or_installed(const std::filesystem::path& file);

}  // namespace brdf::io
