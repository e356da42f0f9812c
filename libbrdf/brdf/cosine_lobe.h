// Powers of a cosine, accurate at the peak for any exponent.
#pragma once

#include "brdf/geometry.h"
#include "brdf/microfacet.h"

namespace brdf {

// Returns (r.o)^n for the mirror direction r. The cosine is computed from
// |r - o|^2 = h_x^2 + h_y^2 + (cos_i - cos_o)^2. The result is 0 if r.o <= 0.
template <class S, class G>
S mirror_cosine_power(const S& n, const Geometry<G>& g) {
  const G apart = g.cos_i - g.cos_o, t = G(0.5) * (square(g.h.x) + square(g.h.y) + square(apart));
  // The rounding errors of the three sums, before they were squared.
  const auto rest = value_of(g.h.x) * value_of(g.h_rest.x) + value_of(g.h.y) * value_of(g.h_rest.y) +
                    value_of(apart) * sum_rest(value_of(g.cos_i), -value_of(g.cos_o), value_of(apart));
  const auto lit = t < G(1);
  const G safe = select(lit, t, G(0.5));
  return select(lit, math::exp(n * math::log1p(-safe, -rest)), S(0));
}

// Returns (n.h)^n = exp(-n/2 log1p(tan^2)), accurate down to the horizon of the half vector.
template <class S, class G>
S half_cosine_power(const S& n, const Geometry<G>& g) {
  const G sine2 = square(g.h.x) + square(g.h.y), inverse = G(1) / square(g.h.z), tan2 = sine2 * inverse;
  const auto twice = [](const G& h, const G& rest) { return (value_of(h) + value_of(h)) * value_of(rest); };
  const auto rest = quotient_rest(value_of(sine2), twice(g.h.x, g.h_rest.x) + twice(g.h.y, g.h_rest.y),
                                  normal_part2(g), value_of(inverse), value_of(tan2));
  return math::exp(n * (G(-0.5) * math::log1p(tan2, rest)));
}

}  // namespace brdf
