#pragma once

#include "brdf/form.h"

namespace brdf {

// (r.o)^n of the mirror direction r, from |r - o|^2 = h_x^2 + h_y^2 + (cos_i - cos_o)^2, so that the peak
// keeps its accuracy for large n; 0 where r.o <= 0.
template <class S, class G>
S mirror_cosine_power(const S& n, const Geometry<G>& g) {
  const G t = G(0.5) * (square(g.h.x) + square(g.h.y) + square(g.cos_i - g.cos_o));
  const auto lit = t < G(1);
  const G safe = select(lit, t, G(0.5));
  return select(lit, math::exp(n * math::log1p(-safe)), S(0));
}

// Phong 1975 as modified by Lewis 1994 (Lafortune and Willems 1994): f = kd/pi + ks (n+2)/(2 pi) (r.o)^n.
// Domain: exponent 0..1e6. Symmetry: isotropic, reciprocal (r.o is symmetric).
// Known violations: none for kd + ks <= 1; it loses energy towards grazing (ks cos(theta) for large n).
struct phong {
  static constexpr std::string_view name = "phong";
  static constexpr std::string_view family = "phong";
  static constexpr NoViolations violations{};
  template <class T>
  using Weights = LobeWeights<T>;
  template <class T>
  using Shape = Exponent<T>;

  template <class S, class G>
  static std::array<S, 2> lobes(const Shape<S>& shape, const Geometry<G>& g) {
    const S k = (shape.exponent + S(2)) * S(1 / (2 * kPi));
    return {S(1 / kPi), k * mirror_cosine_power(shape.exponent, g)};
  }
};

}  // namespace brdf
