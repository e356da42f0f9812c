// The growth of an albedo towards grazing incidence, bounded on both sides.
#pragma once

#include <optional>

#include "prove/search.h"

namespace brdf::prove {

// For light from `from` to 90 degrees the largest albedo of the lobe, over its roughnesses, is K/cos^power
// with K in [low, high].
struct Growth {
  double power, from, low, high;
  double width = 0;  // the roughness at which `low` is reached
  Cover cover{};     // the cover that proves `high`
};

// Bounds the growth. Returns std::nullopt if no method is known, or if the search ended first.
std::optional<Growth> growth_of(int form, const SearchOptions& search);

}  // namespace brdf::prove
