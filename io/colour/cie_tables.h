// The CIE's tables, embedded by the build: comments, a header row, then a wavelength in nm and three numbers
// per row.
#pragma once

namespace brdf::io {

extern const char* const kObserverTable;
extern const char* const kDaylightTable;

}  // namespace brdf::io
