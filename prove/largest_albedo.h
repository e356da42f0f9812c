// The largest directional albedo of a material, by branch and bound over all views.
#pragma once

#include "prove/check/sum_of_albedos.h"
#include "prove/search.h"

namespace brdf::prove {

// The leaves of `cover` have their accuracies. The range of `cover` begins at `low`.
struct LargestAlbedo {
  Domain domain;
  double low = 0;  // a lower bound, reached at the view `low_at`
  Views low_at;
  Cover cover;  // no view exceeds the upper end of its range
};
// Searches the views with the largest upper bounds first, until the largest albedo is known to
// +-half_width. If the brightest view can be shown to be at most `limit`, the search continues until all
// views are at most `limit`. Precondition: the albedo is known.
LargestAlbedo largest_of(const SumOfAlbedos& albedo, double half_width, double limit,
                         const SearchOptions& options);

}  // namespace brdf::prove
