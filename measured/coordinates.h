// Maps pairs of directions to coordinates in which slowly varying quantities are smooth functions.
#pragma once

#include <array>

#include "brdf/vec3.h"

namespace brdf::measured {

// The dependence that a place keeps: without the tangent of the sample (isotropic), or with it (turned).
enum class Turning { isotropic, turned };

constexpr std::size_t kDimensions = 4;
using Place = std::array<double, kDimensions>;

// Returns the place of two unit vectors above the horizon. The half vector h is at (theta_h, phi_h), and
// the direction of incidence is at (theta_d, phi_d) about h (Rusinkiewicz 1998, "A new change of
// variables"). `core` is the width of a lobe's core, in radians.
//
// Isotropic: r = log(1 + (theta_h/core)^2)/2, theta_d (radians), sin theta_h sin theta_d cos 2 phi_d, 0.
// These coordinates do not change under exchange of the directions, rotation of the pair about the normal,
// or reflection in a mirror. They are continuous where phi_d is undefined, and r has no kink at the normal.
// Beyond the core of a lobe r is a logarithm, because the width of features there grows with theta_h.
//
// Turned: q cos phi_h, theta_d, the same third coordinate, q sin phi_h, with q = asinh(theta_h/core).
Place place_of(const Vec3<double>& wi, const Vec3<double>& wo, Turning turning, double core);

}  // namespace brdf::measured
