#pragma once

#include "brdf/form.h"

namespace brdf {

// cos(phi_i - phi_o) sin(theta_i) tan(the smaller angle's partner): x_i x_o + y_i y_o over the larger cosine
// where positive, else 0. No angle is formed, so nothing cancels.
template <class G>
G oren_nayar_azimuth(const Geometry<G>& g) {
  const G s = g.wi.x * g.wo.x + g.wi.y * g.wo.y;
  return select(G(0) < s, s / larger(g.cos_i, g.cos_o), G(0));
}

// Oren and Nayar 1994, the qualitative form (eq. 30): f = rho/pi (A + B max(0, cos dphi) sin a tan b),
// A = 1 - 0.5 s^2/(s^2 + 0.33), B = 0.45 s^2/(s^2 + 0.09), a and b the larger and smaller polar angle, s =
// sigma. Domain: sigma 0..pi/2. Symmetry: isotropic, reciprocal. Known violations: energy, by up to 1.5 % at
// rho = 1 (sigma .1985, towards grazing); none for sigma >= .32613.
struct oren_nayar {
  static constexpr std::string_view name = "oren_nayar";
  static constexpr std::string_view family = "oren_nayar";
  static constexpr std::array violations{Violation{
      "energy", "albedo up to 1.0152 at rho 1, for sigma below .32613", "sigma=0.198533", 90, 1.015179}};
  template <class T>
  using Weights = DiffuseWeights<T>;
  template <class T>
  using Shape = SlopeDeviation<T>;

  template <class S, class G>
  static std::array<S, 1> lobes(const Shape<S>& shape, const Geometry<G>& g) {
    const S s2 = square(shape.sigma);
    const S a = S(1) - S(0.5) * s2 / (s2 + S(0.33));
    const S b = S(0.45) * s2 / (s2 + S(0.09));
    return {S(1 / kPi) * (a + b * oren_nayar_azimuth(g))};
  }
};

}  // namespace brdf
