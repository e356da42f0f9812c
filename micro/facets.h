// What a facet does with a ray.
#pragma once

#include "micro/random.h"
#include "micro/tracer.h"

namespace brdf::micro {

enum class Reflection { mirror, lambert };

struct FacetOptics {
  Reflection reflection = Reflection::mirror;
  double eta = 0;  // mirrors: relative refractive index of a dielectric; 0: reflect everything
  double rho = 1;  // Lambertian facets: albedo
};

// v turned about the macroscopic normal by `azimuth` radians.
Vec turned(const Vec& v, double azimuth);
// The facet's unit normal, pointing up.
Vec normal(const Facet& facet);

struct Scattered {
  Vec direction;
  double weight;  // share of the power that goes on
};
// Where light that travels along `incoming` goes from a facet that faces it; Lambertian facets draw two
// numbers.
Scattered scatter(const FacetOptics& facets, const Facet& facet, const Vec& incoming, Random& random);

// A direction about the facet's normal with density cos / pi.
Vec cosine_direction(const Facet& facet, Random& random);

}  // namespace brdf::micro
