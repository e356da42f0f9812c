// Directions in degrees, the same on every machine.
#pragma once

#include "brdf/directions.h"

namespace brdf::io {

// The unit vector of a direction given in degrees. Built on sin_degrees, so it is the same on every machine.
Vec3<double> unit_vector(double theta, double phi);

// The polar angle in [0, 180] and the azimuth in [0, 360)
// of a direction, in degrees; its length does not matter.
void polar_degrees(const Vec3<double>& w, double& theta, double& phi);

// Sine and cosine of an angle in degrees: exact at multiples of 90, otherwise within 1.5 ulp of the true
// value for |degrees| <= 1e6. Plain arithmetic only: the C library's differ in the last bit between
// processors, and seeded samples must not.
double sin_degrees(double degrees);
double cos_degrees(double degrees);

}  // namespace brdf::io
