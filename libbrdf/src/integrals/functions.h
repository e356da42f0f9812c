// Elementary functions of double for integrals, from sums, products, quotients and roots alone. The functions
// of C libraries differ in their last bits between processors and libraries; these give the same bits
// everywhere.
// Largest error unless stated: 3 ulp.
#pragma once

#include <array>
#include <cmath>

#include "brdf/kernels.h"

namespace brdf::integrals {

// The coefficients 1/n! of Taylor's series.
inline constexpr std::array kSinh{1.0,          1.0 / 6,        1.0 / 120,        1.0 / 5040,
                                  1.0 / 362880, 1.0 / 39916800, 1.0 / 6227020800, 1.0 / 1307674368000};
inline constexpr std::array kSin{1.0,          -1.0 / 6,        1.0 / 120,        -1.0 / 5040,
                                 1.0 / 362880, -1.0 / 39916800, 1.0 / 6227020800, -1.0 / 1307674368000};
inline constexpr std::array kCos{1.0,
                                 -1.0 / 2,
                                 1.0 / 24,
                                 -1.0 / 720,
                                 1.0 / 40320,
                                 -1.0 / 3628800,
                                 1.0 / 479001600,
                                 -1.0 / 87178291200,
                                 1.0 / 20922789888000};

namespace detail {

// The multiple of pi/2 nearest to x, and the rest in [-pi/4, pi/4], by two parts of pi/2 (Cody and Waite
// 1980).
struct Reduced {
  int quarter;  // 0 to 3
  double rest;
};
inline Reduced reduced(double x) {
  constexpr double kHigh = 1.57079632673412561417,
                   kLow = 6.07710050650619224932e-11;           // fdlibm: pio2_1, pio2_1t
  constexpr double kMagic = kernels::Precision<double>::magic;  // rounds to the nearest integer
  const double n = (x * (2 / kPi) + kMagic) - kMagic;
  return {int(n) & 3, (x - n * kHigh) - n * kLow};
}
// Sine and cosine of x in [-pi/4, pi/4].
inline double sine(double x) {
  const double z = x * x;
  return x + x * (z * kernels::horner(
                          z, std::array{kSin[1], kSin[2], kSin[3], kSin[4], kSin[5], kSin[6], kSin[7]}));
}
inline double cosine(double x) {
  const double z = x * x;
  return 1 - (0.5 * z - z * z *
                            kernels::horner(z, std::array{kCos[2], kCos[3], kCos[4], kCos[5], kCos[6],
                                                          kCos[7], kCos[8]}));
}

}  // namespace detail

// |x| must be at most 1e5. Next to a zero the error is at most 1e-25 for |x| up to 10.
inline double sin(double x) {
  const auto [quarter, rest] = detail::reduced(x);
  const double value = quarter & 1 ? detail::cosine(rest) : detail::sine(rest);
  return quarter & 2 ? -value : value;
}
inline double cos(double x) {
  const auto [quarter, rest] = detail::reduced(x);
  const double value = quarter & 1 ? detail::sine(rest) : detail::cosine(rest);
  return (quarter + 1) & 2 ? -value : value;
}
inline double tan(double x) {
  return sin(x) / cos(x);
}
inline double atan(double x) {
  return std::copysign(kernels::angle(std::abs(x), 1.0), x);
}
// |x| must be at most 1. Largest error: 4 ulp.
inline double acos(double x) {
  return 2 * kernels::angle(std::sqrt(1 - x), std::sqrt(1 + x));
}
// |x| must be at most 690.
inline double sinh(double x) {
  const double up = kernels::exp(std::abs(x));
  return std::abs(x) < 0.5 ? x * kernels::horner(x * x, kSinh) : std::copysign(0.5 * (up - 1 / up), x);
}
inline double cosh(double x) {
  const double up = kernels::exp(std::abs(x));
  return 0.5 * (up + 1 / up);
}
// |x| must be at most 1e100.
inline double asinh(double x) {
  const double size = std::abs(x);
  return std::copysign(kernels::log1p(size + size * (size / (1 + std::sqrt(1 + size * size))), 0.0), x);
}
// x must be 0, or between 1e-200 and 1e200.
inline double cbrt(double x) {
  if (x == 0) return 0;
  const double root = kernels::exp(kernels::log(x) / 3);
  return root - (root - x / (root * root)) / 3;
}
// x and y must be 0, or between 1e-150 and 1e150.
inline double hypot(double x, double y) {
  return std::sqrt(x * x + y * y);
}

}  // namespace brdf::integrals
