#pragma once

#include "brdf/form.h"

namespace brdf {

template <class T>
struct LafortuneShape {
  T tilt, exponent;
  static constexpr auto fields() {
    return std::array{
        Field{&LafortuneShape::tilt,
              ParameterInfo{"tilt", 0.2, 1, 0.9, 1, "", false,
                            "C_z over -C_x: below 1 the lobe leans to the horizon", Role::other}},
        Field{&LafortuneShape::exponent,
              ParameterInfo{"exponent", 0, 1e4, 20, 1e3, "", true, "power of the cosine", Role::exponent}}};
  }
};

// Lafortune et al. 1997, one isotropic lobe (eq. 5) with -C_x = -C_y = 1 and Phong's normalisation: f =
// kd/pi + ks (n + 2)/(2 pi) max(0, C_z i_z o_z - i_x o_x - i_y o_y)^n.
// Domain: C_z 0.2..1, exponent 0..1e4.
// Symmetry: isotropic, reciprocal.
// No violation is known for kd + ks <= 1. The domain excludes C_z above 1, for which the lobe would be
// unbounded.
struct lafortune : Takes<LobeWeights, LafortuneShape> {
  static constexpr std::string_view name = "lafortune";
  static constexpr std::string_view family = "lafortune";
  static constexpr NoViolations violations{};

  template <class S, class G>
  static std::array<S, 2> lobes(const Shape<S>& shape, const Geometry<G>& g) {
    const S cosine = shape.tilt * (g.cos_i * g.cos_o) - (g.wi.x * g.wo.x + g.wi.y * g.wo.y);
    return {S(1 / kPi),
            (shape.exponent + S(2)) * S(1 / (2 * kPi)) * math::pow(at_least(cosine, S(0)), shape.exponent)};
  }
};

}  // namespace brdf
