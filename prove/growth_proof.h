// The growth of an albedo towards grazing, bounded on both sides.
#pragma once

#include <optional>

#include "prove/search.h"

namespace brdf::prove {

// For light from `from` degrees to 90 the largest albedo of the lobe, over its widths, is K/cos^power with K
// in [low, high].
struct Growth {
  double power, from, low, high;
  double width = 0;  // at which `low` is reached
  Cover cover{};     // of `high`
};

// None where no method is known, or the search ended first.
std::optional<Growth> growth_of(int form, const SearchOptions& search);

}  // namespace brdf::prove
