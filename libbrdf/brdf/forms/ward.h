#pragma once

#include "brdf/form.h"
#include "brdf/microfacet.h"

namespace brdf {

// exp(-tan^2): the Gaussian of the half vector's slope, scaled by the widths. 0 below e^-80 (float), e^-690
// (double).
template <class S, class G>
S slope_gaussian(const Roughness<S>& a, const Geometry<G>& g) {
  return math::exp(-(scaled_tangent2(a, g) / square(g.h.z)));
}

// Ward 1992 eq. 5a: f = kd/pi + ks exp(-((h_x/alpha_x)^2 + (h_y/alpha_y)^2)/h_z^2) / (4 pi alpha_x alpha_y
// sqrt(cos_i cos_o)). Domain: alpha 1e-4..1. Symmetry: anisotropic, reciprocal. Known violations: energy,
// beyond 89.4 degrees (the albedo grows as 1/sqrt(cos)); below, it loses up to 74 %.
struct ward {
  static constexpr std::string_view name = "ward";
  static constexpr std::string_view family = "ward";
  static constexpr std::array violations{
      Violation{"energy", "albedo above 1 beyond 89.42 degrees, growing as 1/sqrt(cos)",
                "kd=0 ks=1 alpha_x=1 alpha_y=0.0001", 89.5, 1.072}};
  template <class T>
  using Weights = LobeWeights<T>;
  template <class T>
  using Shape = Roughness<T>;

  template <class S, class G>
  static std::array<S, 2> lobes(const Shape<S>& shape, const Geometry<G>& g) {
    const S scale = S(4 * kPi) * shape.alpha_x * shape.alpha_y;
    return {S(1 / kPi), slope_gaussian(shape, g) / (scale * math::sqrt(g.cos_i * g.cos_o))};
  }
};

}  // namespace brdf
