// The CIE's tables, embedded by the build. They consist of comments, a header row, and rows with a
// wavelength in nm and three numbers.
#pragma once

namespace brdf::io {

extern const char* const kObserverTable;
extern const char* const kDaylightTable;

}  // namespace brdf::io
