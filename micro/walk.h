// The path of a ray over the surface, and an account of the distribution of its power.
#pragma once

#include <numeric>
#include <vector>

#include "micro/facets.h"
#include "micro/random.h"
#include "micro/tracer.h"

namespace brdf::micro {

// Shares of the incident power; they sum to 1. Orders count reflections.
struct Account {
  std::vector<double> escaped;  // [order - 1], up to the bounce limit
  double absorbed = 0;          // absorbed by facets that do not reflect everything
  double beyond = 0;            // still travelling after the last allowed reflection
  double leaked = 0;            // lost through the mesh (rounding)

  double albedo() const { return std::accumulate(escaped.begin(), escaped.end(), 0.0); }
  double lost() const { return beyond + leaked; }
};

// Follows one ray of weight 1 that arrives from `wi` (unit, towards the source) over the share (u, v) of
// the period. Adds the result to the account. Calls leave(order, wo, weight) if the ray leaves the surface.
template <class Leave>
void walk(Tracer& tracer, const FacetOptics& facets, const Vec& wi, double u, double v, Random& random,
          Account& account, const Leave& leave) {
  const int limit = static_cast<int>(account.escaped.size());
  Vec position = tracer.entry(u, v);
  const double azimuth = tracer.surface().azimuth_at(position.x);
  Vec travel = turned(wi * -1.0, -azimuth);
  double weight = 1;
  Facet facet;
  for (int order = 0;; ++order) {
    const bool last = order == limit;
    const Fate fate = !last                              ? tracer.next(position, travel, facet)
                      : tracer.escapes(position, travel) ? Fate::escaped
                                                         : Fate::hit;
    if (fate == Fate::escaped && order > 0) {
      account.escaped[order - 1] += weight;
      leave(order, turned(travel, azimuth), weight);
      return;
    }
    if (fate != Fate::hit) {
      account.leaked += weight;
      return;
    }
    if (last) {
      account.beyond += weight;
      return;
    }
    const Scattered s = scatter(facets, facet, travel, random);
    account.absorbed += weight * (1 - s.weight);
    weight *= s.weight;
    travel = s.direction;
  }
}

}  // namespace brdf::micro
