// Rows of the plane of incidence.
#pragma once

#include "io/samples.h"

namespace brdf::io {

// The viewer's angle of a row in the plane of incidence (within half a degree of azimuth), degrees: positive on the mirror
// side. NaN outside that plane.
double in_plane_angle(const SampleTable& table, std::size_t row);

}  // namespace brdf::io
