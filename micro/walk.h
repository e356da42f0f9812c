// The path of a ray over the surface, and an account of the distribution of its power.
#pragma once

#include <numeric>
#include <vector>

#include "micro/facets.h"
#include "micro/surface.h"

namespace brdf::micro {

// Shares of the incident power; they sum to 1. Orders count reflections.
struct Account {
  std::vector<double> escaped;  // [order - 1], up to the bounce limit
  double absorbed = 0;          // absorbed by facets that do not reflect everything
  double beyond = 0;            // still travelling after the last allowed reflection
  double leaked = 0;            // still travelling after the limit of steps (march.glsl)

  double albedo() const { return std::accumulate(escaped.begin(), escaped.end(), 0.0); }
  double lost() const { return beyond + leaked; }
};

// Follows a ray of weight 1 over Lambertian facets of albedo rho; as path_over_mirrors in march.glsl.
Path path_over_lambert(March& march, const Vec& wi, double u, double v, double rho, int limit,
                       Random& random);

// Adds the path to the account. Calls leave(order, wo, weight) if the path leaves the surface.
template <class Leave>
void settle(const Path& path, Account& account, const Leave& leave) {
  account.absorbed += path.absorbed;
  if (path.fate == March::escaped && path.order > 0) {
    account.escaped[std::size_t(path.order) - 1] += path.weight;
    leave(path.order, path.travel, path.weight);
  } else {
    (path.fate == March::hit ? account.beyond : account.leaked) += path.weight;
  }
}

// Follows one ray of weight 1 that arrives from `wi` (unit, towards the source) over the share (u, v) of
// the period, and settles it.
template <class Leave>
void walk(March& march, const FacetOptics& facets, const Vec& wi, double u, double v, Random& random,
          Account& account, const Leave& leave) {
  const int limit = int(account.escaped.size());
  settle(facets.reflection == Reflection::mirror
             ? march.path_over_mirrors(wi, u, v, facets.eta, limit)
             : path_over_lambert(march, wi, u, v, facets.rho, limit, random),
         account, leave);
}

}  // namespace brdf::micro
