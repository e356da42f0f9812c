// Reflection of a ray at a facet.
#pragma once

#include "micro/march.h"
#include "micro/random.h"

namespace brdf::micro {

enum class Reflection { mirror, lambert };

struct FacetOptics {
  Reflection reflection = Reflection::mirror;
  double eta = 0;  // mirrors: relative index of refraction of a dielectric; 0: perfect reflector
  double rho = 1;  // Lambertian facets: albedo
};

// Returns the unit normal of the facet, which points up.
Vec normal(const Facet& facet);
// Returns a random direction about the normal of the facet with density cos / pi; draws two random numbers.
Vec cosine_direction(const Facet& facet, Random& random);

}  // namespace brdf::micro
