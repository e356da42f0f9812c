#pragma once

#include "brdf/form.h"
#include "brdf/microfacet.h"

namespace brdf {

// Cook and Torrance 1982 with the distribution of Trowbridge and Reitz (GGX), height-correlated Smith masking
// (Heitz 2014) and Schlick's Fresnel: f = kd/pi + ks D G F/(4 cos_i cos_o), F = f0 + (1 - f0)(1 - wi.h)^5.
// Linear given the widths: lobes 1/pi, V D, V D s with weights kd, ks f0, ks (1 - f0).
// Domain: alpha 1e-4..1, f0 0..1. Symmetry: anisotropic, reciprocal.
// Known violations: none for kd + ks <= 1; single scattering loses up to 69 % (alpha 1, normal incidence).
struct cook_torrance {
  static constexpr std::string_view name = "cook_torrance";
  static constexpr std::string_view family = "cook_torrance";
  static constexpr NoViolations violations{};
  template <class T>
  using Weights = SchlickWeights<T>;
  template <class T>
  using Shape = Roughness<T>;

  template <class S, class G>
  static std::array<S, 3> lobes(const Shape<S>& shape, const Geometry<G>& g) {
    const S vd = quotient(d_ggx(shape, g), v_smith_ggx(shape, g));
    return {S(1 / kPi), vd, vd * schlick(g)};
  }
};

}  // namespace brdf
