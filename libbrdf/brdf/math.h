// Elementary functions for every scalar: brdf::math::exp, log, log1p, sqrt, pow, angle, erfcx.
//
// float, double: the kernels of brdf/kernels.h. Dual and ceres::Jet: one chain rule. The tracing scalar: a
// call of the traced kernel. Anything else (a 50-digit number): the type's own function, found by
// argument-dependent lookup.
#pragma once

#include <cmath>

#include "brdf/kernels.h"

namespace brdf::math {

template <class T>
concept Plain = std::same_as<T, float> || std::same_as<T, double>;
template <class T>
concept Foreign = !Plain<T> && !Differentiated<T>;

inline constexpr double kTwoOverSqrtPi = 1.12837916709551257390;

namespace lookup {  // nothing here is named like the functions below, so that only the argument's own is
                    // found
using std::sqrt;
template <class T>
T call_exp(const T& x) {
  return exp(x);
}
template <class T>
T call_log(const T& x) {
  return log(x);
}
template <class T>
T call_log1p(const T& x) {
  return log1p(x);
}
template <class T>
T call_sqrt(const T& x) {
  return sqrt(x);
}
template <class T>
T call_erfcx(const T& x) {
  return erfcx(x);
}
template <class T>
T call_atan2(const T& y, const T& x) {
  return atan2(y, x);
}
}  // namespace lookup

template <Plain T>
inline T exp(const T& x) {
  return kernels::exp(x);
}
template <Foreign T>
T exp(const T& x) {
  return lookup::call_exp(x);
}
template <Differentiated T>
inline T exp(const T& x) {
  const auto y = math::exp(x.a);
  return T{y, x.v * y};
}

template <Plain T>
inline T log(const T& x) {
  return kernels::log(x);
}
template <Foreign T>
T log(const T& x) {
  return lookup::call_log(x);
}
template <Differentiated T>
inline T log(const T& x) {
  using B = base_scalar_t<T>;
  return T{math::log(x.a), x.v * (B(1) / x.a)};
}

template <Plain T>
inline T log1p(const T& x) {
  return kernels::log1p(x);
}
template <Foreign T>
T log1p(const T& x) {
  return lookup::call_log1p(x);
}
template <Differentiated T>
inline T log1p(const T& x) {
  using B = base_scalar_t<T>;
  return T{math::log1p(x.a), x.v * (B(1) / (B(1) + x.a))};
}

template <Plain T>
inline T sqrt(const T& x) {
  return std::sqrt(x);
}
template <Foreign T>
T sqrt(const T& x) {
  return lookup::call_sqrt(x);
}
template <Differentiated T>
inline T sqrt(const T& x) {
  using B = base_scalar_t<T>;
  const B y = math::sqrt(x.a);
  return T{y, x.v * (B(0.5) / at_least(y, B(1e-30)))};
}

template <Plain T>
inline T erfcx(const T& x) {
  return kernels::erfcx(x);
}
template <Foreign T>
T erfcx(const T& x) {
  return lookup::call_erfcx(x);
}
template <Differentiated T>
inline T erfcx(const T& x) {
  using B = base_scalar_t<T>;
  const B y = math::erfcx(x.a);
  return T{y, x.v * (B(2) * x.a * y - B(kTwoOverSqrtPi))};
}

// Angle of (cosine, sine) in the first quadrant.
template <Plain T>
inline T angle(const T& sine, const T& cosine) {
  return kernels::angle(sine, cosine);
}
template <Foreign T>
T angle(const T& sine, const T& cosine) {
  return lookup::call_atan2(sine, cosine);
}
template <Differentiated T>
inline T angle(const T& sine, const T& cosine) {
  using B = base_scalar_t<T>;
  const B scale = B(1) / at_least(square(sine.a) + square(cosine.a), B(1e-30));
  return T{math::angle(sine.a, cosine.a), sine.v * (cosine.a * scale) + cosine.v * (-sine.a * scale)};
}

// x^y for x >= 0, 0 at x = 0; relative error |y log x| ulp.
template <class T>
inline T pow(const T& x, const T& y) {
  const T tiny(1e-37);
  return select(x < tiny, T(0), math::exp(y * math::log(at_least(x, tiny))));
}

}  // namespace brdf::math
