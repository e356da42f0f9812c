// The studio in which pictures show a material: three soft boxes, a wall that is dark at the horizon, and a
// bright floor on which a ball stands.
//
// Everything is written once, for numbers and for the scalar that generates shaders. y is up, and the
// viewer looks along -z.
#pragma once

#include <array>
#include <cmath>

#include "brdf/math.h"
#include "brdf/vec3.h"
#include "io/colour/neutral.h"

namespace brdf::io::studio {

// A rectangular light: the direction of its centre, the directions across and upwards, the tangents of half
// its angles, and the share of these over which its edge fades.
struct SoftBox {
  Vec3<double> centre, across, up;
  std::array<double, 2> half;
  double edge;
  std::array<double, 3> radiance;
};
// Returns the key light at the upper left front, a strip at the right, and a rim light behind and above.
const std::array<SoftBox, 3>& soft_boxes();

// Radiance of the wall at the horizon and straight up, and of the floor straight down.
inline constexpr double kHorizon = 0.05, kZenith = 0.45, kFloor = 0.7;
// The cosines to the vertical at which wall and floor reach these values.
inline constexpr double kWallRise = 0.8, kFloorRise = 0.18;

namespace detail {

template <class S>
Vec3<S> converted(const Vec3<double>& v) {
  return {S(v.x), S(v.y), S(v.z)};
}

template <class S>
S smooth(const S& low, const S& high, const S& x) {
  const S t = at_most(at_least((x - low) / (high - low), S(0)), S(1));
  return t * t * (S(3) - S(2) * t);
}

// The place of a direction in a box, in units of its half sides.
template <class S>
struct Place {
  S facing;  // cosine to the centre, at least 0.01
  S across, up;
};
template <class S>
Place<S> place_in(const SoftBox& box, const Vec3<S>& w) {
  const S facing = at_least(dot(w, converted<S>(box.centre)), S(0.01));
  const auto size = [](const S& x) { return select(x < S(0), -x, x); };
  return {facing, size(dot(w, converted<S>(box.across)) / (facing * S(box.half[0]))),
          size(dot(w, converted<S>(box.up)) / (facing * S(box.half[1])))};
}

// Returns 1 inside and 0 outside, with a smooth transition over the edge.
template <class S>
S inside(const S& t, double edge) {
  return S(1) - smooth(S(1 - edge), S(1 + edge), t);
}

}  // namespace detail

// Returns the radiance from a direction (a unit vector), if nothing stands on the floor.
template <class S>
std::array<S, 3> radiance(const Vec3<S>& w) {
  const S wall = mixed(S(kHorizon), S(kZenith), detail::smooth(S(0), S(kWallRise), w.y)),
          floor = mixed(S(kHorizon), S(kFloor), detail::smooth(S(0), S(kFloorRise), -w.y));
  const S around = select(w.y < S(0), floor, wall);
  std::array<S, 3> sum{around, around, around};
  for (const SoftBox& box : soft_boxes()) {
    const detail::Place<S> place = detail::place_in(box, w);
    const S share = select(S(0.01) < place.facing,
                           detail::inside(place.across, box.edge) * detail::inside(place.up, box.edge), S(0));
    for (std::size_t c = 0; c < 3; ++c) sum[c] = sum[c] + S(box.radiance[c]) * share;
  }
  return sum;
}

// Returns the share of uniform light from above that reaches a place of the floor next to a ball: the
// ball's centre is at `height` above the floor, `distance2` is the square of the horizontal distance. This
// is exact if the whole ball is above the floor: the ball takes the share r^2 cos/D^2 of the cosine-weighted
// hemisphere.
template <class S>
S light_beside_ball(const S& height, const S& radius, const S& distance2) {
  const S d2 = distance2 + height * height;
  return at_least(S(1) - height * radius * radius / (d2 * math::sqrt(d2)), S(0));
}

// Returns the share of the radiance of the direction w that reaches the place p of a unit ball that stands
// on the floor: below the horizon, the light of the place of the floor that w leads to; above, 1.
template <class S>
S floor_share(const Vec3<S>& p, const Vec3<S>& w) {
  const S t = (p.y + S(1)) / at_least(-w.y, S(1e-4));
  const S x = p.x + t * w.x, z = p.z + t * w.z;
  return select(w.y < S(0), light_beside_ball(S(1), S(1), x * x + z * z), S(1));
}

// Returns a direction to each box, for two numbers in [0, 1). Their density per solid angle is
// box_density(), summed over the boxes.
template <class S>
std::array<Vec3<S>, 3> box_directions(const S& u1, const S& u2) {
  std::array<Vec3<S>, 3> out;
  for (std::size_t k = 0; k < 3; ++k) {
    const SoftBox& box = soft_boxes()[k];
    const Vec3<S> w =
        detail::converted<S>(box.centre) +
        detail::converted<S>(box.across) * ((S(2) * u1 - S(1)) * S(box.half[0] * (1 + box.edge))) +
        detail::converted<S>(box.up) * ((S(2) * u2 - S(1)) * S(box.half[1] * (1 + box.edge)));
    out[k] = w * (S(1) / math::sqrt(dot(w, w)));
  }
  return out;
}
template <class S>
S box_density(const Vec3<S>& w) {
  S sum(0);
  for (const SoftBox& box : soft_boxes()) {
    const detail::Place<S> place = detail::place_in(box, w);
    const S side = S(1 + box.edge), farthest = larger(place.across, place.up);
    const S area = S(4 * box.half[0] * box.half[1] * (1 + box.edge) * (1 + box.edge));
    const S density = S(1) / (area * place.facing * place.facing * place.facing);
    sum = sum + select(S(0.01) < place.facing, select(farthest < side, density, S(0)), S(0));
  }
  return sum;
}

}  // namespace brdf::io::studio
