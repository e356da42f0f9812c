// Cheaper Fresnel terms of dielectrics (eta is n) and conductors.
#pragma once

#include "brdf/fresnel.h"
#include "trade/measure/rows.h"

namespace brdf::trade {

template <class T>
T fifth_power(const T& x) {
  return square(square(x)) * x;
}

inline constexpr auto exact_dielectric = []<class T>(const FresnelRow<T>& x) -> T {
  return fresnel_dielectric(x.n, x.cosine);
};

// Schlick 1994: f0 + (1 - f0)(1 - c)^5.
inline constexpr auto schlick_fresnel = []<class T>(const FresnelRow<T>& x) -> T {
  return x.f0 + (T(1) - x.f0) * fifth_power(T(1) - x.cosine);
};

// Lagarde 2012 / Karis 2013: the fifth power as 2^((-5.55473 c - 6.98316) c).
inline constexpr auto gaussian_dielectric = []<class T>(const FresnelRow<T>& x) -> T {
  const T log2 = (T(-5.55473) * x.cosine - T(6.98316)) * x.cosine;
  return x.f0 + (T(1) - x.f0) * math::exp(log2 * T(0.69314718055994531));
};

// Independent of the angle.
inline constexpr auto constant_dielectric = []<class T>(const FresnelRow<T>& x) -> T { return x.f0; };

// The error of the lookup-texture article.
inline constexpr auto slipped_dielectric = []<class T>(const FresnelRow<T>& x) -> T {
  return fresnel_dielectric_as_coded(x.n, x.cosine);
};

inline constexpr auto exact_conductor = []<class T>(const FresnelRow<T>& x) -> T {
  return fresnel_conductor(x.n, x.k, x.cosine);
};

// Lazanyi and Szirmay-Kalos 2005: Schlick's term minus a c (1 - c)^e, with Hoffman's (2019) choice of e = 6,
// and a from the exact value at 82 degrees (c = 1/7).
inline constexpr auto lazanyi_conductor = []<class T>(const FresnelRow<T>& x) -> T {
  const T u = T(1) - x.cosine;
  const T u5 = fifth_power(u);
  return x.f0 + (T(1) - x.f0) * u5 - x.dip * x.cosine * u5 * u;
};

// Pharr and Humphreys 2004 (first edition): both polarisations, with sin^2 neglected compared with n^2 +
// k^2.
inline constexpr auto simplified_conductor = []<class T>(const FresnelRow<T>& x) -> T {
  const T c = x.cosine, n = x.n, m = square(x.n) + square(x.k), c2 = c * c;
  const T rp = (m * c2 - T(2) * n * c + T(1)) / (m * c2 + T(2) * n * c + T(1));
  const T rs = (m - T(2) * n * c + c2) / (m + T(2) * n * c + c2);
  return T(0.5) * (rp + rs);
};

}  // namespace brdf::trade
