// Chart.js, the library that draws the plots of a report: a file of the system, or part of the page for
// browsers.
#pragma once

#include <filesystem>
#include <string>

namespace brdf::io {

// Returns the file of Chart.js that reports embed. Throws EnvironmentError if there is no such file.
std::filesystem::path chart_file_for_reports();

// Returns the text of Chart.js. Throws EnvironmentError like chart_file_for_reports().
std::string chart_text();

}  // namespace brdf::io
