// Directions that reflect light and that a density leaves out, found without the sampler.
#pragma once

#include "validate/joint/trio.h"

namespace brdf::validate {

struct Holes {
  long directions = 0, dark = 0;  // with f cos_i above 0; of these, with a density that is not above 0
  double share = 0;            // estimate of the part of the albedo at dark directions, of the worst channel
  Vec3<double> brightest{};    // the dark direction with the largest f cos_i
  double brightest_value = 0;  // f cos_i there, 1/sr
};

// Looks at a direction in each of kHoleDirections cells of equal projected solid angle. A hole is missed with
// a probability of at most exp(-kHoleDirections s), where s is its share of the projected hemisphere.
inline constexpr long kHoleDirections = 1 << 16;
Holes holes_of(const Trio& trio, std::uint64_t seed);

// Returns the share s of holes that are missed with this probability.
double least_hole(double probability);

}  // namespace brdf::validate
