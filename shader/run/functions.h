// GLSL's elementary functions for every scalar. float: the result in double, rounded to float, which is
// correctly rounded except for about one argument in 1e8. double: the functions of the standard library.
// Dual: the chain rule. Other types (50 digits, an interval): the type's own functions, found by
// argument-dependent lookup. A scalar with other names for these functions specialises Functions.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "brdf/dual.h"
#include "brdf/math.h"

namespace brdf::shader {

// For double and for types with functions of their own.
template <class T>
struct OwnFunctions {
  static T number(double x) { return T(x); }
  static T sqrt(const T& x) {
    using std::sqrt;
    return sqrt(x);
  }
  static T exp(const T& x) {
    using std::exp;
    return exp(x);
  }
  static T log(const T& x) {
    using std::log;
    return log(x);
  }
  static T sin(const T& x) {
    using std::sin;
    return sin(x);
  }
  static T cos(const T& x) {
    using std::cos;
    return cos(x);
  }
  static T tan(const T& x) {
    using std::tan;
    return tan(x);
  }
  static T asin(const T& x) {
    using std::asin;
    return asin(x);
  }
  static T acos(const T& x) {
    using std::acos;
    return acos(x);
  }
  static T atan(const T& x) {
    using std::atan;
    return atan(x);
  }
  static T atan2(const T& y, const T& x) {
    using std::atan2;
    return atan2(y, x);
  }
  static T sinh(const T& x) {
    using std::sinh;
    return sinh(x);
  }
  static T cosh(const T& x) {
    using std::cosh;
    return cosh(x);
  }
  static T tanh(const T& x) {
    using std::tanh;
    return tanh(x);
  }
  static T floor(const T& x) {
    using std::floor;
    return floor(x);
  }
  static T trunc(const T& x) {
    using std::trunc;
    return trunc(x);
  }
  static T exp2(const T& x) { return exp(x * T(0.69314718055994530942)); }
  static T log2(const T& x) { return log(x) / T(0.69314718055994530942); }
  // For a base below 0 GLSL leaves pow undefined, and drivers give NaN. This function gives NaN for every
  // exponent.
  static T pow(const T& x, const T& y) {
    using std::pow;
    return x < T(0) ? T(std::numeric_limits<double>::quiet_NaN()) : pow(x, y);
  }
  static T log1p(const T& x, const T& rest) { return math::log1p(x, rest); }
  static T erfcx(const T& x) { return math::erfcx(x); }
  static T angle(const T& sine, const T& cosine) { return math::angle(sine, cosine); }
  static double value(const T& x) { return double(x); }
  static std::uint32_t bits(const T& x) { return std::bit_cast<std::uint32_t>(float(x)); }
  static T from_bits(std::uint32_t bits) { return T(double(std::bit_cast<float>(bits))); }
};

template <class T>
struct Functions : OwnFunctions<T> {};

// The processor's extended type, for which the library has no kernels.
template <>
struct Functions<long double> : OwnFunctions<long double> {
  using T = long double;
  static T log1p(const T& x, const T& rest) { return std::log1p(x + rest); }
  // Beyond x = 100 exp(x^2) may overflow, so the asymptotic value is used.
  static T erfcx(const T& x) {
    constexpr T kRootPi = 1.7724538509055160273L;
    return x > 100 ? 1 / (x * kRootPi) : std::exp(x * x) * std::erfc(x);
  }
  static T angle(const T& sine, const T& cosine) { return std::atan2(sine, cosine); }
};

template <>
struct Functions<float> {
  static float number(double x) { return float(x); }
  static float sqrt(float x) { return std::sqrt(x); }
  // Uses the library's kernels in double, which can be vectorised.
  static double wide_log(float x) {
    const double y = math::log(double(x));
    return x > 0             ? (x > std::numeric_limits<float>::max() ? double(x) : y)
           : x < 0 || x != x ? std::numeric_limits<double>::quiet_NaN()
                             : -std::numeric_limits<double>::infinity();
  }
  static float exp(float x) { return float(math::exp(double(x))); }
  static float log(float x) { return float(wide_log(x)); }
  static float sin(float x) { return float(std::sin(double(x))); }
  static float cos(float x) { return float(std::cos(double(x))); }
  static float tan(float x) { return float(std::tan(double(x))); }
  static float asin(float x) { return float(std::asin(double(x))); }
  static float acos(float x) { return float(std::acos(double(x))); }
  static float atan(float x) { return float(std::atan(double(x))); }
  static float atan2(float y, float x) { return float(std::atan2(double(y), double(x))); }
  static float sinh(float x) { return float(std::sinh(double(x))); }
  static float cosh(float x) { return float(std::cosh(double(x))); }
  static float tanh(float x) { return float(std::tanh(double(x))); }
  static float floor(float x) { return std::floor(x); }
  static float trunc(float x) { return std::trunc(x); }
  static float exp2(float x) { return float(math::exp(double(x) * 0.69314718055994530942)); }
  static float log2(float x) { return float(wide_log(x) * 1.44269504088896340736); }
  static float pow(float x, float y) {
    const double value = math::exp(double(y) * wide_log(x));
    return y == 0 && x >= 0 ? 1.0f : float(value);
  }
  static float log1p(float x, float rest) { return math::log1p(x, rest); }
  static float erfcx(float x) { return math::erfcx(x); }
  static float angle(float sine, float cosine) { return math::angle(sine, cosine); }
  static double value(float x) { return double(x); }
  static std::uint32_t bits(float x) { return std::bit_cast<std::uint32_t>(x); }
  static float from_bits(std::uint32_t bits) { return std::bit_cast<float>(bits); }
};

// A value and a slope make a dual number. Infinite slopes are limited to a large number, so that a fit can
// continue.
template <class B, int N>
struct Functions<Dual<B, N>> {
  using T = Dual<B, N>;
  using F = Functions<B>;
  static constexpr double kSteepest = 1e15;
  static T make(const B& value, const T& x, const B& slope) {
    const B limit(kSteepest);
    const B held = slope != slope ? B(0) : slope > limit ? limit : slope < -limit ? -limit : slope;
    return {value, x.v * held};
  }
  static T number(double x) { return T(x); }
  static T sqrt(const T& x) {
    const B y = F::sqrt(x.a);
    return make(y, x, B(0.5) / y);
  }
  static T exp(const T& x) {
    const B y = F::exp(x.a);
    return make(y, x, y);
  }
  static T log(const T& x) { return make(F::log(x.a), x, B(1) / x.a); }
  static T sin(const T& x) { return make(F::sin(x.a), x, F::cos(x.a)); }
  static T cos(const T& x) { return make(F::cos(x.a), x, -F::sin(x.a)); }
  static T tan(const T& x) {
    const B y = F::tan(x.a);
    return make(y, x, B(1) + y * y);
  }
  static T asin(const T& x) { return make(F::asin(x.a), x, B(1) / F::sqrt(B(1) - x.a * x.a)); }
  static T acos(const T& x) { return make(F::acos(x.a), x, B(-1) / F::sqrt(B(1) - x.a * x.a)); }
  static T atan(const T& x) { return make(F::atan(x.a), x, B(1) / (B(1) + x.a * x.a)); }
  static T atan2(const T& y, const T& x) {
    const B scale = B(1) / (x.a * x.a + y.a * y.a);
    const T by_y = make(F::atan2(y.a, x.a), y, x.a * scale), by_x = make(B(0), x, -(y.a * scale));
    return {by_y.a, by_y.v + by_x.v};
  }
  static T sinh(const T& x) { return make(F::sinh(x.a), x, F::cosh(x.a)); }
  static T cosh(const T& x) { return make(F::cosh(x.a), x, F::sinh(x.a)); }
  static T tanh(const T& x) {
    const B y = F::tanh(x.a);
    return make(y, x, B(1) - y * y);
  }
  static T floor(const T& x) { return T(F::floor(x.a)); }
  static T trunc(const T& x) { return T(F::trunc(x.a)); }
  static T exp2(const T& x) {
    const B y = F::exp2(x.a);
    return make(y, x, y * B(0.69314718055994530942));
  }
  static T log2(const T& x) { return make(F::log2(x.a), x, B(1.44269504088896340736) / x.a); }
  static T pow(const T& x, const T& y) {
    const B value = F::pow(x.a, y.a);
    const T by_x = make(value, x, x.a > B(0) ? y.a * value / x.a : y.a * F::pow(x.a, y.a - B(1))),
            by_y = make(B(0), y, x.a > B(0) ? value * F::log(x.a) : B(0));
    return {value, by_x.v + by_y.v};
  }
  static T log1p(const T& x, const T& rest) { return math::log1p(x, rest.a); }
  static T erfcx(const T& x) { return math::erfcx(x); }
  static T angle(const T& sine, const T& cosine) { return math::angle(sine, cosine); }
  static double value(const T& x) { return F::value(x.a); }
  static std::uint32_t bits(const T& x) { return F::bits(x.a); }
  static T from_bits(std::uint32_t bits) { return T(double(std::bit_cast<float>(bits))); }
};

}  // namespace brdf::shader
