// The phase angle of planetary photometry.
#pragma once

namespace brdf::io {

// Returns the azimuth, from 0 to 180 degrees, between the directions of the light and the viewer, which
// have these polar angles and enclose the angle `phase`; 0 if one of the directions is the normal. All
// angles are in degrees. Returns NaN if no azimuth gives this angle within half a degree.
double azimuth_of_phase(double theta_i, double theta_o, double phase);

}  // namespace brdf::io
