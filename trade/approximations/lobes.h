// Cheaper lobes.
#pragma once

#include <cmath>

#include "brdf/cosine_lobe.h"
#include "trade/approximations/masking.h"

namespace brdf::trade {

// c^n.
inline constexpr auto cosine_power = []<class T>(const CosineRow<T>& x) -> T {
  return math::pow(x.cosine, x.width);
};
inline constexpr auto cosine_power_libm = []<class T>(const CosineRow<T>& x) -> T {
  return std::pow(x.cosine, x.width);
};
// Wang et al. 2009: a spherical Gaussian e^(n (c - 1)).
inline constexpr auto spherical_gaussian = []<class T>(const CosineRow<T>& x) -> T {
  return math::exp(x.width * (x.cosine - T(1)));
};
// Schlick 1994: c/(n - n c + c).
inline constexpr auto schlick_power = []<class T>(const CosineRow<T>& x) -> T {
  return x.cosine / (x.width - x.width * x.cosine + x.cosine);
};
// Repeated squaring for an exponent known at compile time.
template <int doublings>
inline constexpr auto squared_power = []<class T>(const CosineRow<T>& x) -> T {
  T y = x.cosine;
  for (int k = 0; k < doublings; ++k) y = y * y;
  return y;
};

// Returns r.o for the mirror direction r = 2 (n.l) n - l, with n = +z.
template <class T>
T mirror_cosine(const DirectionRow<T>& x) {
  return x.wi.z * x.wo.z - x.wi.x * x.wo.x - x.wi.y * x.wo.y;
}

// Phong's lobe (r.o)^n computed from vectors, as in a renderer.
inline constexpr auto mirror_lobe = []<class T>(const DirectionRow<T>& x) -> T {
  return math::pow(at_least(mirror_cosine(x), T(0)), x.width);
};
// Blinn's half vector with `factor` times the exponent. A factor of 4 makes the lobe as narrow as Phong's.
struct half_lobe {
  double factor;
  template <class T>
  T operator()(const DirectionRow<T>& x) const {
    const Vec3<T> h = x.wi + x.wo;
    const T c = h.z / math::sqrt(dot(h, h));
    return math::pow(c, T(factor) * x.width);
  }
};
// Phong's lobe computed through differences; accurate at the peak for any exponent.
inline constexpr auto mirror_lobe_stable = []<class T>(const DirectionRow<T>& x) -> T {
  return mirror_cosine_power(x.width, geometry_of(x));
};

// D of GGX.
inline constexpr auto ggx_stable = []<class T>(const DirectionRow<T>& x) -> T {
  const Fraction<T> d = d_ggx(Roughness<T>{x.width, x.width}, geometry_of(x));
  return d.num / d.den;
};
// The usual formula, alpha^2/(pi ((n.h)^2 (alpha^2 - 1) + 1)^2), with a normalised half vector.
inline constexpr auto ggx_naive = []<class T>(const DirectionRow<T>& x) -> T {
  Vec3<T> h = x.wi + x.wo;
  h = h * (T(1) / math::sqrt(dot(h, h)));
  const T a2 = x.width * x.width;
  const T t = h.z * h.z * (a2 - T(1)) + T(1);
  return a2 / (T(kPi) * t * t);
};

}  // namespace brdf::trade
