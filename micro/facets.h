// Reflection of a ray at a facet.
#pragma once

#include "micro/random.h"
#include "micro/tracer.h"

namespace brdf::micro {

enum class Reflection { mirror, lambert };

struct FacetOptics {
  Reflection reflection = Reflection::mirror;
  double eta = 0;  // mirrors: relative index of refraction of a dielectric; 0: perfect reflector
  double rho = 1;  // Lambertian facets: albedo
};

// Returns v rotated about the macroscopic normal by `azimuth` radians.
Vec turned(const Vec& v, double azimuth);
// Returns the unit normal of the facet, which points up.
Vec normal(const Facet& facet);

struct Scattered {
  Vec direction;
  double weight;  // share of the power that continues
};
// Returns the direction of light that travelled along `incoming` and met the front of the facet. Lambertian
// facets draw two random numbers.
Scattered scatter(const FacetOptics& facets, const Facet& facet, const Vec& incoming, Random& random);

// Returns a random direction about the normal of the facet with density cos / pi.
Vec cosine_direction(const Facet& facet, Random& random);

}  // namespace brdf::micro
