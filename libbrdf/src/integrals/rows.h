// Elementary functions over a row of nodes at once (as brdf/quadrature.h's sinh_cosh).
#pragma once

#include <cstddef>

namespace brdf::integrals {

// Sine and cosine of angles in [0, pi]. Largest error of
// both 5e-16; the sine's is relative for angles to pi/2.
void sin_cos(std::size_t count, const double* angle, double* sine, double* cosine);

}  // namespace brdf::integrals
