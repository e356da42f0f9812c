#pragma once

#include "brdf/form.h"

namespace brdf {

// (n.h)^n = exp(-n/2 log1p(tan^2)), accurate at the peak for any n and down to the half vector's horizon.
template <class S, class G>
S half_cosine_power(const S& n, const Geometry<G>& g) {
  const G tan2 = (square(g.h.x) + square(g.h.y)) / square(g.h.z);
  return math::exp(n * (G(-0.5) * math::log1p(tan2)));
}

// Blinn 1977 with the exact normalisation: f = kd/pi + ks k (n.h)^n, k = (n+2)(n+4)/(8 pi (2^(-n/2) + n)),
// which makes the lobe's albedo ks at normal incidence. Domain: exponent 0..1e6. Symmetry: isotropic,
// reciprocal. Known violations: none for kd + ks <= 1; it loses energy towards grazing (ks cos^2(theta) for
// large n).
struct blinn_phong {
  static constexpr std::string_view name = "blinn_phong";
  static constexpr std::string_view family = "blinn_phong";
  static constexpr NoViolations violations{};
  template <class T>
  using Weights = LobeWeights<T>;
  template <class T>
  using Shape = Exponent<T>;

  template <class S, class G>
  static std::array<S, 2> lobes(const Shape<S>& shape, const Geometry<G>& g) {
    const S& n = shape.exponent;
    const S k = (n + S(2)) * (n + S(4)) / (S(8 * kPi) * (math::exp(n * S(-0.34657359027997265)) + n));
    return {S(1 / kPi), k * half_cosine_power(n, g)};
  }
};

}  // namespace brdf
