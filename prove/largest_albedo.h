// The largest directional albedo of a material, by branch and bound over all views.
#pragma once

#include "prove/search.h"
#include "prove/sum_of_albedos.h"

namespace brdf::prove {

// Of `cover` the range, what is open and how many boxes were evaluated: it is no tree.
struct LargestAlbedo {
  Domain domain;
  double low = 0;  // some direction has that
  Cover cover;     // none exceeds the end of its range
};
// Looks where it may be largest first, until it is known to +-half_width. The albedo is known.
LargestAlbedo largest_of(const SumOfAlbedos& albedo, double half_width, const SearchOptions& options);

}  // namespace brdf::prove
