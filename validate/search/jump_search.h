// Searches for steps of f within the hemisphere, with light and viewer above the horizon.
#pragma once

#include <optional>

#include "validate/search/pair_search.h"

namespace brdf::validate {

struct Jump {
  Material at;
  // At most 1e-12 of an arc apart; an arc covers 89 or 216 degrees.
  Pair here, there;
  double before = 0, after = 0;  // f, 1/sr, of one channel
  double value = 0;              // |before - after| over the larger, which counts as at least kFaintest
};

// Returns the largest step found that exceeds `least`; std::nullopt if there is no such step. The search
// follows arcs of the viewer and of the light, in the polar angle and in the azimuth, at the subject's own
// parameters and over a cover of its domain. Each large change is bisected until it is identified as a
// step, or as smooth. Adds the number of evaluations to `evaluations`.
std::optional<Jump> largest_jump(const Subject& subject, const CheckOptions& options, double least,
                                 long& evaluations);

}  // namespace brdf::validate
