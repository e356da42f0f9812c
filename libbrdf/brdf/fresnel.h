// Fresnel reflectance of unpolarised light at a smooth interface.
//
// All functions take the cosine of the angle of incidence c in [0, 1] and return a reflectance in [0, 1],
// except the misprinted one.
#pragma once

#include "brdf/math.h"

namespace brdf {

namespace detail {
inline constexpr double kFresnelFloor = 1e-30;  // prevents 0/0 if both media are equal
}

// Returns the exact reflectance of a dielectric with relative index eta > 0 (Cook and Torrance 1982 eq.
// 15). g - c is written as (eta^2 - 1)/(g + c), which is accurate for eta near 1. The result is 0 for
// eta = 1 (also at c = 0), otherwise 1 for c = 0, and 1 for total reflection (eta < 1). Relative error for
// eta 1..5: 1.2e-15, in float 5e-7.
template <class S, class G>
S fresnel_dielectric(const S& eta, const G& c) {
  const S step = (eta - S(1)) * (eta + S(1));
  const S g2 = step + c * c;
  const auto total = g2 < S(0);
  const S g = math::sqrt(select(total, S(0), g2));
  const S sum = g + c;
  const S difference = step / at_least(sum, S(detail::kFresnelFloor));
  const S s = difference / at_least(sum, S(detail::kFresnelFloor));
  const S p = (c * sum - S(1)) / (c * difference + S(1));
  return select(total, S(1), S(0.5) * square(s) * (S(1) + square(p)));
}

// Returns the same as written in the code of the lookup-texture article. There (g-c)(g-c)/(g+c)*(g+c)
// evaluates to (g-c)^2, which gives 0.25 instead of 0.04 for glass (eta 1.5) at normal incidence, and 1.25
// at grazing incidence. The result is not a reflectance; its upper bound is (eta^2 - 1). Domain: eta >= 1.
template <class S, class G>
S fresnel_dielectric_as_coded(const S& eta, const G& c) {
  const S g = math::sqrt((eta - S(1)) * (eta + S(1)) + c * c);
  const S p = (c * (g + c) - S(1)) / (c * (g - c) + S(1));
  return S(0.5) * square(g - c) * (S(1) + square(p));
}

// Returns the exact reflectance of a conductor with complex index n + i k, n and k in [0, 20]. With
// (a + i b)^2 = (n + i k)^2 - sin^2:
// R_s = ((a - c)^2 + b^2)/((a + c)^2 + b^2),
// R_p = R_s ((a c - sin^2)^2 + (b c)^2)/((a c + sin^2)^2 + (b c)^2).
// All terms are sums of squares. There is no cancellation for metals, and the result never exceeds 1. k = 0
// gives the dielectric; n = k = 0 gives 1. Relative error: 2.2e-15, in float 2.6e-6
// (n >= 0.05, k >= 1e-3 or 0).
template <class T>
T fresnel_conductor(const T& n, const T& k, const T& c) {
  const T sin2 = at_least((T(1) - c) * (T(1) + c), T(0));
  const T excess = (n - T(1)) * (n + T(1)) - square(k);  // Re(index^2) - 1
  const T re = excess + square(c);                       // Re((a + i b)^2)
  const T nk = n * k;
  const auto metal = re < T(0);
  const T big = T(0.5) * (math::sqrt(square(re) + T(4) * square(nk)) + select(metal, -re, re));
  const T small = square(nk) / at_least(big, T(detail::kFresnelFloor));
  const T a = math::sqrt(select(metal, small, big));
  const T b2 = select(metal, big, small);
  const T sum = a + c;
  // a - c cancels if the indices match. It is then computed as (a^2 - c^2)/(a + c).
  const T difference = select(metal, a - c, (excess + b2) / at_least(sum, T(detail::kFresnelFloor)));
  const auto ratio = [](const T& numerator, const T& denominator) {
    return select(denominator < T(detail::kFresnelFloor), T(1), numerator / denominator);
  };
  const T matched = square(sum) + b2;
  const T s = select(matched < T(detail::kFresnelFloor), T(0), (square(difference) + b2) / matched);
  const T p = s * ratio(square(a * c - sin2) + b2 * square(c), square(a * c + sin2) + b2 * square(c));
  return at_most(T(0.5) * (s + p), T(1));
}

}  // namespace brdf
