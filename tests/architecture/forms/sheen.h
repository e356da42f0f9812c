#pragma once

#include "brdf/form.h"

namespace brdf {

template <class T>
struct SheenWidth {
  T alpha;
  static constexpr auto fields() {
    return std::array{Field{
        &SheenWidth::alpha,
        ParameterInfo{"alpha", 1e-2, 1, 0.3, 1, "", true, "width of the fibres' directions", Role::width}}};
  }
};

// Estevez and Kulla 2017 ("Charlie"): f = kd/pi + ks D V with D = (2 + 1/alpha) sin_h^(1/alpha) / (2 pi)
// and V = 1/(4 (cos_i + cos_o - cos_i cos_o)) of Neubelt and Pettineo 2013.
// Domain: alpha 0.01..1.
// Symmetry: isotropic, reciprocal.
// Known violations: energy towards grazing angles, most of all at the smallest alpha.
struct sheen : Takes<LobeWeights, SheenWidth> {
  static constexpr std::string_view name = "sheen";
  static constexpr std::string_view family = "sheen";
  static constexpr Kink kink = Kink::none;
  static constexpr std::array violations{
      Violation{"energy", "albedo above 1 towards grazing, about 4 for the smallest width",
                "kd=0 ks=1 alpha=0.01", 89.5, 3.267688}};

  template <class S, class G>
  static std::array<S, 2> lobes(const Shape<S>& shape, const Geometry<G>& g) {
    const S power = S(1) / shape.alpha;
    const G sine2 = at_most((square(g.h.x) + square(g.h.y)) / g.h2, G(1));
    const S d = (S(2) + power) * S(1 / (2 * kPi)) * math::pow(S(sine2), S(0.5) * power);
    const G v = G(0.25) / (g.cos_i + g.cos_o - g.cos_i * g.cos_o);
    return {S(1 / kPi), d * v};
  }
};

}  // namespace brdf
