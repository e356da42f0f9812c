// Steps of f within the hemisphere, where light and viewer stand above the horizon.
#pragma once

#include <optional>

#include "validate/search/pair_search.h"

namespace brdf::validate {

struct Jump {
  Material at;
  Pair here, there;              // at most 1e-12 rad from one another
  double before = 0, after = 0;  // f, 1/sr, of one channel
  double value = 0;              // their difference over the larger, which counts as at least kFaintest
};

// The largest found, of those beyond `least`: along arcs of the viewer and of the light, in the polar angle
// and in the azimuth, at the subject's own parameters and over a cover of its domain, each large change cut
// in halves until it is smooth or is none.
std::optional<Jump> largest_jump(const Subject& subject, const CheckOptions& options, double least,
                                 long& evaluations);

}  // namespace brdf::validate
