// Style and scripts of the reports' template, embedded by the build.
#pragma once

namespace brdf::io {

extern const char* const kPageStyle;
extern const char* const kPageScript;   // of every page
extern const char* const kBodyScript;   // of figures that readers turn
extern const char* const kChartScript;  // follows `const plots = [...]`

}  // namespace brdf::io
