// Pairs of directions at which code that is not ours breaks: within the hemisphere, where directions
// coincide, and at the horizon.
#pragma once

#include <vector>

#include "validate/search/pair_search.h"

namespace brdf::validate {

// inside: anywhere above the horizon, a share of the hemisphere. coincident: light and viewer are one
// direction, mirror each other, or one of them is the normal or at a round angle, a set of no area. horizon:
// one of the cosines is below 1e-16, or negative.
enum class Where { inside, coincident, horizon };

struct PlacedPair {
  Pair pair;  // its vectors are those that `brdf eval` makes of its angles, bit for bit
  Where where;
};

// `inside` pairs spread evenly over both hemispheres, `angles` polar angles of coincident directions (some
// fail by their last bit only), and all pairs of a few directions at, near and below the horizon.
// Deterministic by the seed.
std::vector<PlacedPair> placed_pairs(std::size_t inside, std::size_t angles, std::uint64_t seed);

}  // namespace brdf::validate
