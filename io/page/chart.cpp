#include <fstream>
#include <iterator>

#include "io/files/error.h"
#include "io/files/installed.h"
#include "io/page/chart.h"

#ifndef BRDF_CHART_JS
#define BRDF_CHART_JS "/usr/share/javascript/chart.js/chart.min.js"
#endif

namespace brdf::io {
namespace {

// Returns the file of Chart.js: next to the program, or in the place of the distribution.
std::filesystem::path chart_file() {
  for (const char* name : {"brdf/chart.min.js", "javascript/chart.js/chart.min.js"})
    if (std::filesystem::path file = installed_file(name); !file.empty()) return file;
  return BRDF_CHART_JS;
}

}  // namespace

std::filesystem::path chart_file_for_reports() {
  std::filesystem::path file = chart_file();
  if (!std::filesystem::is_regular_file(file))
    throw EnvironmentError("HTML reports need Chart.js at " BRDF_CHART_JS " (Debian: libjs-chart.js)");
  return file;
}

std::string chart_text() {
  std::ifstream file(chart_file_for_reports(), std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace brdf::io
