// Pairs of directions at which outside code typically fails: within the hemisphere, where directions
// coincide, and at the horizon.
#pragma once

#include <vector>

#include "validate/search/pair_search.h"

namespace brdf::validate {

// inside: anywhere above the horizon, a positive share of the hemisphere. coincident: light and viewer have
// the same direction or mirror each other, or one of them is the normal or at a round angle; these pairs
// have no area. horizon: one of the cosines is below 1e-16 or negative.
enum class Where { inside, coincident, horizon };

struct PlacedPair {
  Pair pair;  // its vectors are bit for bit the vectors that `brdf eval` computes
  Where where;
};

// Returns `inside` pairs spread evenly over both hemispheres, coincident directions at `angles` polar
// angles (some fail only in the last bit), and all pairs of a few directions at, near and below the
// horizon. Deterministic for a given seed.
std::vector<PlacedPair> placed_pairs(std::size_t inside, std::size_t angles, std::uint64_t seed);

}  // namespace brdf::validate
