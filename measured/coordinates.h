// Pairs of directions as places, so that what varies slowly over them is a smooth function of the place.
#pragma once

#include <array>

#include "brdf/vec3.h"

namespace brdf::measured {

// What a place keeps of a pair: without the tangent (isotropic), or with it.
enum class Turning { isotropic, turned };

constexpr std::size_t kDimensions = 4;
using Place = std::array<double, kDimensions>;

// Of two unit vectors above the horizon. Half vector h at (theta_h, phi_h), the light at (theta_d, phi_d)
// about it (Rusinkiewicz 1998, "A new change of variables"). Isotropic: r = log(1 + (theta_h/core)^2)/2,
// theta_d (radians), sin theta_h sin theta_d cos 2 phi_d, 0. These are the same when light and viewer are
// exchanged, when the pair turns about the normal, and in a mirror; nothing jumps where phi_d is undefined,
// and r has no point at the normal. Beyond the core of a lobe it is a logarithm, as the width of what is seen
// there grows with theta_h. Turned: q cos phi_h, theta_d, the same third, q sin phi_h with q =
// asinh(theta_h/core).
Place place_of(const Vec3<double>& wi, const Vec3<double>& wo, Turning turning, double core);

}  // namespace brdf::measured
