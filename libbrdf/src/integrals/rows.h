// Elementary functions for a whole row of nodes (like sinh_cosh in brdf/quadrature.h).
#pragma once

#include <cstddef>

namespace brdf::integrals {

// Computes sine and cosine of angles in [0, pi]. Largest error of both: 5e-16. The error of the sine is
// relative for angles up to pi/2.
void sin_cos(std::size_t count, const double* angle, double* sine, double* cosine);

}  // namespace brdf::integrals
