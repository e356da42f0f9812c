// The rate at which an unbounded albedo grows towards grazing incidence.
#pragma once

#include "prove/scalar/enclosed.h"

namespace brdf::prove {

// For light from `from` to 90 degrees, the largest albedo over the roughnesses is K/cos^power. K is
// enclosed.
struct GrowthMethod {
  double power, from;
  Domain domain;  // roughness along the light, cosine
  // Bounds cos^power times the largest albedo of facets of that roughness along the light, for any
  // roughness across.
  Bounds (*most)(std::span<const Bounds> box);
  // Bounds the same product at the least roughness across. The form reaches these values.
  Bounds (*reached)(std::span<const Bounds> box);
};

// The lower ends of `reached` at that width, over parts of the range of cosines: the least and the largest
// of them. `least` holds for all cosines.
struct Reached {
  double least, most;
};
Reached reached_at(const GrowthMethod& method, double width);

// Returns the method that belongs to the recorded formula of the form; null for other forms.
const GrowthMethod* growth_method(int form);

}  // namespace brdf::prove
