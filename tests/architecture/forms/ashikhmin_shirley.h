#pragma once

#include "brdf/form.h"
#include "brdf/microfacet.h"

namespace brdf {

template <class T>
struct TwoExponents {
  T exponent_x, exponent_y;
  static constexpr auto fields() {
    return std::array{
        Field{&TwoExponents::exponent_x, ParameterInfo{"exponent_x", 0, 1e5, 20, 1e4, "", true,
                                                       "power along the tangent", Role::exponent}},
        Field{&TwoExponents::exponent_y, ParameterInfo{"exponent_y", 0, 1e5, 20, 1e4, "", true,
                                                       "power across the tangent", Role::exponent_across}}};
  }
};

// Ashikhmin and Shirley 2000, the specular lobe (eq. 4): f = kd/pi + ks F sqrt((nu + 1)(nv + 1))/(8 pi)
// (n.h)^(nu cos^2 + nv sin^2) / (h.o max(n.i, n.o)). cos and sin are taken of the azimuth of h; F is
// Schlick's.
// Domain: exponents 0..1e5.
// Symmetry: anisotropic, reciprocal.
// No violation is known for kd = 0.
struct ashikhmin_shirley : Takes<SchlickWeights, TwoExponents> {
  static constexpr std::string_view name = "ashikhmin_shirley";
  static constexpr std::string_view family = "ashikhmin_shirley";
  static constexpr NoViolations violations{};

  // Returns ln(1 + t)/t for t >= 0.
  template <class G>
  static G log1p_over(const G& t) {
    const auto small = t < G(1e-4);
    const G safe = select(small, G(1), t);
    return select(small, G(1) - t * (G(0.5) - t * G(1.0 / 3)), math::log1p(safe) / safe);
  }

  template <class S, class G>
  static std::array<S, 3> lobes(const Shape<S>& shape, const Geometry<G>& g) {
    // (n.h)^e = exp(-(nu p^2 + nv q^2)/2 ln(1 + t)/t) with the slopes p, q of h and t = p^2 + q^2.
    const G p2 = square(g.h.x / g.h.z), q2 = square(g.h.y / g.h.z);
    const S power = (shape.exponent_x * p2 + shape.exponent_y * q2) * (G(-0.5) * log1p_over(p2 + q2));
    const S scale = math::sqrt((shape.exponent_x + S(1)) * (shape.exponent_y + S(1))) * S(1 / (8 * kPi));
    const S lobe = scale * math::exp(power) / (g.cos_d * larger(g.cos_i, g.cos_o));
    return {S(1 / kPi), lobe, lobe * schlick(g)};
  }
};

}  // namespace brdf
