// The energy that Ward's lobes reflect. Let (p, q) be the slopes of h, P22 their Gaussian density, s = 1 +
// p^2 + q^2, and u = p tan(theta_i), with p along the azimuth of the light. h is not normalised. Then
//   d omega_o = 2 h_z^3/|h|^2 dp dq,   cos_i + cos_o = h_z,   h_z = 2 cos_i (1 + u)/s,   |h|^2 = s h_z^2,
// and the direction o is above the horizon if 2 (1 + u) > s. With A = cos_i (1 + u) = cos_i + sin_i p,
//   ward          f cos_o d omega_o = P22 A sqrt(2 A/s - cos_i)/(s^2 sqrt(cos_i)) dp dq,
//   ward_duer     f cos_o d omega_o = P22 A/(s^2 cos_i) dp dq,
//   ward_bounded  f cos_o d omega_o = P22 R dp dq,   R = 2 cos_o/(cos_i + cos_o) = 2 - s/(1 + u).
#pragma once

#include "brdf/microfacet.h"
#include "prove/scalar/lemmas.h"

namespace brdf::prove {

enum class WardKind { root, product, bounded };

// Returns the lobe as the form writes it.
template <WardKind kind, class S, class G>
S ward_lobe(const Roughness<S>& a, const Geometry<G>& g) {
  const G inverse = G(1) / square(g.h.z);
  const S gaussian = slope_gaussian(a, g, inverse);
  if constexpr (kind == WardKind::bounded) {
    return gaussian * (g.h2 * square(inverse)) / (S(kPi) * a.alpha_x * a.alpha_y);
  } else {
    const S scale = S(4 * kPi) * a.alpha_x * a.alpha_y;
    const G cosines = g.cos_i * g.cos_o;
    if constexpr (kind == WardKind::root)
      return gaussian / (scale * math::sqrt(cosines));
    else
      return gaussian / (scale * cosines);
  }
}

// Returns an upper bound of the mean of R at (p, q) and (-p, -q). R alone may be 2, but P22 is the same at
// both slopes, and the mean of both R is at most 1. For u >= 0, if both are lit, the mean is
// 2 - s/(1 - u^2) = 2 - 1/m <= m, m = (1 - u^2)/s. If only the first is lit, the mean is
// 1 - s/(2 (1 + u)) <= 1 - 1/(2 (1 + u)), since s >= 1. `facet` is 1/s, the squared cosine of the facet.
// The facet's tilt u is given by u_to_1 up to 1 and by inverse_beyond_1 = 1/u beyond.
template <class T>
T ward_bounded_mean(const T& facet, const T& u_to_1, const T& inverse_beyond_1) {
  const T both = facet * (T(1) - square(u_to_1));
  // 1/(1 + u), for u = u_to_1 or 1/inverse_beyond_1, whichever is not 1
  const T rest = T(1) / (T(1) + u_to_1) + inverse_beyond_1 / (T(1) + inverse_beyond_1) - T(0.5);
  return larger(both, T(1) - T(0.5) * rest);
}

}  // namespace brdf::prove
