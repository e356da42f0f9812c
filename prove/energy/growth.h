// How fast an albedo that is not bounded grows towards grazing.
#pragma once

#include <optional>
#include <string>

#include "prove/scalar/enclosed.h"

namespace brdf::prove {

// For light from `from` degrees to 90, the largest albedo over the widths is K/cos^power; K is enclosed.
struct GrowthMethod {
  double power, from;
  Domain domain;  // width along the light, cosine
  // cos^power times the largest albedo of facets of that width along the light, whatever the width across.
  Bounds (*most)(std::span<const Bounds> box);
  // The same at the least width across: that is reached.
  Bounds (*reached)(std::span<const Bounds> box);
};

// What the second holds at that width for all cosines: the least of the lower ends over parts of their range,
// and the largest.
struct Reached {
  double least, most;
};
Reached reached_at(const GrowthMethod& method, double width);

// The one that the form's recorded formula is of; none for others.
const GrowthMethod* growth_method(int form);

}  // namespace brdf::prove
