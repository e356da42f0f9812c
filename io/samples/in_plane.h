// Selects rows in the plane of incidence.
#pragma once

#include "io/samples/samples.h"

namespace brdf::io {

// The largest angle, in degrees, between a viewing direction and the plane of incidence at which a row is
// drawn and judged as in the plane. Instruments keep to this tolerance. A wider band would mix rows from
// the side of a narrow highlight into its middle: at 2.5 degrees a lobe of alpha 0.026 has fallen by one
// half, at 0.5 degrees by 3 %. The angle is measured from the plane rather than as an azimuth, because an
// azimuth is meaningless near the normal.
inline constexpr double kInPlane = 0.5;  // degrees

// Returns whether a viewing direction is in the plane of incidence. `theta_o`: polar angle in degrees;
// `turn`: azimuth from the light or from the mirror direction, in degrees.
bool is_in_plane(double theta_o, double turn);

// Returns the signed viewing angle of a row in the plane of incidence, in degrees, positive on the mirror
// side. Returns NaN for a row outside the plane.
double in_plane_angle(const SampleTable& table, std::size_t row);

}  // namespace brdf::io
