// Elementary functions for every scalar: brdf::math::exp, log, log1p, sqrt, pow, angle, erfcx.
//
// float and double use the kernels of brdf/kernels.h. Dual and ceres::Jet share one chain rule. The tracing
// scalar records a call of the traced kernel. Any other type (a 50-digit number) uses its own function,
// found by argument-dependent lookup.
#pragma once

#include <cmath>
#include <concepts>

#include "brdf/kernels.h"

namespace brdf::math {

template <class T>
concept Plain = std::same_as<T, float> || std::same_as<T, double>;

inline constexpr double kTwoOverSqrtPi = 1.12837916709551257390;

// Calls of the functions that belong to a type. No name here equals the name of a function below; lookup
// therefore finds the functions of the type only.
namespace lookup {
using std::sqrt;
inline constexpr auto call_exp = [](const auto& x) { return exp(x); };
inline constexpr auto call_log = [](const auto& x) { return log(x); };
inline constexpr auto call_log1p = [](const auto& x) { return log1p(x); };
inline constexpr auto call_log1p_with_rest = [](const auto& x, const auto& rest) { return log1p(x, rest); };
inline constexpr auto call_sqrt = [](const auto& x) { return sqrt(x); };
inline constexpr auto call_erfcx = [](const auto& x) { return erfcx(x); };
inline constexpr auto call_atan2 = [](const auto& y, const auto& x) { return atan2(y, x); };
inline constexpr auto call_upper_half = [](const auto& x) { return upper_half(x); };
// Types that record formulas keep the rounding errors that other types ignore.
template <class T>
concept KeepsRests = requires(const T& x) {
  log1p(x, x);
  upper_half(x);
};
}  // namespace lookup

// Returns x with the lower half of its mantissa set to 0; products of two such numbers are exact. Other
// types do not need this and return x.
template <class T>
inline T upper_half(const T& x) {
  if constexpr (Plain<T> || std::same_as<T, Traced>)
    return kernels::upper_half(x);
  else if constexpr (lookup::KeepsRests<T>)
    return lookup::call_upper_half(x);
  else
    return x;
}

// Each function has three cases: plain numbers, derivatives by the chain rule, and all other types.

template <class T>
inline T exp(const T& x) {
  if constexpr (Plain<T>) {
    return kernels::exp(x);
  } else if constexpr (Differentiated<T>) {
    const auto y = math::exp(x.a);
    return T{y, x.v * y};
  } else {
    return lookup::call_exp(x);
  }
}

template <class T>
inline T log(const T& x) {
  if constexpr (Plain<T>)
    return kernels::log(x);
  else if constexpr (Differentiated<T>)
    return T{math::log(x.a), x.v * (base_scalar_t<T>(1) / x.a)};
  else
    return lookup::call_log(x);
}

// Returns log(1 + x + rest). |rest| is a few ulp of x: the rounding error of x.
template <class T>
inline T log1p(const T& x, const decltype(value_of(x))& rest) {
  using B = base_scalar_t<T>;
  if constexpr (Plain<T>)
    return kernels::log1p(x, rest);
  else if constexpr (Differentiated<T>)
    return T{math::log1p(x.a, rest), x.v * (B(1) / (B(1) + x.a))};
  else if constexpr (std::same_as<T, Traced> || lookup::KeepsRests<T>)
    return lookup::call_log1p_with_rest(x, rest);
  else
    return lookup::call_log1p(x + rest);
}
template <class T>
inline T log1p(const T& x) {
  return math::log1p(x, std::remove_cvref_t<decltype(value_of(x))>(0));
}

template <class T>
inline T sqrt(const T& x) {
  if constexpr (Differentiated<T>) {
    using B = base_scalar_t<T>;
    const B y = math::sqrt(x.a);
    return T{y, x.v * (B(0.5) / at_least(y, B(1e-30)))};
  } else {
    return lookup::call_sqrt(x);
  }
}

template <class T>
inline T erfcx(const T& x) {
  if constexpr (Plain<T>) {
    return kernels::erfcx(x);
  } else if constexpr (Differentiated<T>) {
    using B = base_scalar_t<T>;
    const B y = math::erfcx(x.a);
    return T{y, x.v * (B(2) * x.a * y - B(kTwoOverSqrtPi))};
  } else {
    return lookup::call_erfcx(x);
  }
}

// Returns the angle of (cosine, sine) in the first quadrant.
template <class T>
inline T angle(const T& sine, const T& cosine) {
  if constexpr (Plain<T>) {
    return kernels::angle(sine, cosine);
  } else if constexpr (Differentiated<T>) {
    using B = base_scalar_t<T>;
    const B scale = B(1) / at_least(square(sine.a) + square(cosine.a), B(1e-30));
    return T{math::angle(sine.a, cosine.a), sine.v * (cosine.a * scale) + cosine.v * (-sine.a * scale)};
  } else {
    return lookup::call_atan2(sine, cosine);
  }
}

// Returns x^y for x >= 0, and 0 for x = 0. Relative error: |y log x| ulp.
template <class T>
inline T pow(const T& x, const T& y) {
  const T tiny(1e-37);
  return select(x < tiny, T(0), math::exp(y * math::log(at_least(x, tiny))));
}

}  // namespace brdf::math
