// Rows of the plane of incidence.
#pragma once

#include "io/samples/samples.h"

namespace brdf::io {

// A viewer whose direction is within this angle of the plane is drawn and judged as in it: what instruments
// keep to. A wider band would put rows beside a narrow highlight into its middle: at 2.5 degrees a lobe of
// alpha .026 has fallen by a half, at half a degree by 3 %. Measured from the plane, not in azimuth, which
// says nothing near the normal.
inline constexpr double kInPlane = 0.5;  // degrees

// Of a viewer at theta_o, `turn` from the light's azimuth or from the mirror direction's; degrees.
bool is_in_plane(double theta_o, double turn);

// The viewer's angle of a row in the plane of incidence, degrees: positive on the mirror side. NaN outside
// that plane.
double in_plane_angle(const SampleTable& table, std::size_t row);

}  // namespace brdf::io
