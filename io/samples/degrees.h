// Directions in degrees, computed identically on every machine.
#pragma once

#include "brdf/directions.h"

namespace brdf::io {

// Returns the unit vector of a direction given in degrees. Uses sin_degrees(), so that the result is the
// same on every machine.
Vec3<double> unit_vector(double theta, double phi);

// Degrees: theta in [0, 180], phi in [0, 360).
struct Polar {
  double theta, phi;
};

// Returns the polar angle and the azimuth of a direction. The length of `w` does not matter.
Polar polar_degrees(const Vec3<double>& w);

// Returns the azimuth in [0, 360), never -0.
double within_turn(double phi);

// Return the sine and the cosine of an angle in degrees: exact at multiples of 90, otherwise within 1.5 ulp
// of the true value for |degrees| <= 1e6. The functions use plain arithmetic only, because the functions of
// the C library differ in the last bit between processors. Seeded samples must not differ.
double sin_degrees(double degrees);
double cos_degrees(double degrees);

}  // namespace brdf::io
