// Ranges of directions from which a surface is seen.
#pragma once

#include <array>
#include <cmath>
#include <utility>

#include "prove/scalar/enclosed.h"

namespace brdf::prove {

// Ranges of stretched views: turns from the normal and, for unequal roughnesses, turns from the first axis
// to the second, 0 to 1 (Domain).
struct Views {
  Bounds turn, azimuth{0, 0};
};
// An albedo over views, and the part of its width that is due to their turns and to their azimuths.
struct AlbedoBounds {
  Bounds value;
  std::array<double, 2> reach{};
};

// Encloses (cos, sin) of a turn in [-2, 2], see Domain. Both are monotone between whole turns.
template <class I>
void circle(Bounds turn, I& cosine, I& sine) {
  const auto at = [](double t) {
    const I x = I(1) - I::of(std::fabs(t), std::fabs(t));
    const I y = std::fabs(t) <= 1 ? I::of(t, t) : (t > 0 ? I(2) - I::of(t, t) : I(-2) - I::of(t, t));
    const I length = sqrt(square(x) + square(y));
    return std::pair(x / length, y / length);
  };
  const auto [c0, s0] = at(turn.lo);
  const auto [c1, s1] = at(turn.hi);
  cosine = hull(c0, c1);
  sine = hull(s0, s1);
  const auto holds = [&](double t) { return turn.lo <= t && t <= turn.hi; };
  if (holds(0)) cosine.hi = 1;
  if (holds(-2) || holds(2)) cosine.lo = -1;
  if (holds(1)) sine.hi = 1;
  if (holds(-1)) sine.lo = -1;
}

}  // namespace brdf::prove
