// The largest directional albedo of a material, by branch and bound over all views.
#pragma once

#include "prove/check/sum_of_albedos.h"
#include "prove/search.h"

namespace brdf::prove {

// Leaves of `cover` have their accuracies; its range begins at `low`.
struct LargestAlbedo {
  Domain domain;
  double low = 0;  // the view `low_at` has at least that
  Views low_at;
  Cover cover;  // none exceeds the end of its range
};
// Looks where it may be largest first, until it is known to +-half_width. The albedo is known.
LargestAlbedo largest_of(const SumOfAlbedos& albedo, double half_width, const SearchOptions& options);

}  // namespace brdf::prove
