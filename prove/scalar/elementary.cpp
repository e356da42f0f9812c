#include "prove/scalar/elementary.h"

#include <algorithm>
#include <cmath>

namespace brdf::prove {
namespace {

// Outward rounded arithmetic on numbers that are >= 0 or of known sign: the few operations that the series
// need.
Bounds outward(double low, double high) {
  return {low - (std::fabs(low) * 0x1p-52 + 0x1p-1074), high + (std::fabs(high) * 0x1p-52 + 0x1p-1074)};
}
Bounds operator+(Bounds a, Bounds b) {
  return outward(a.lo + b.lo, a.hi + b.hi);
}
Bounds operator-(Bounds a, Bounds b) {
  return outward(a.lo - b.hi, a.hi - b.lo);
}
Bounds operator*(Bounds a, Bounds b) {
  const double p = a.lo * b.lo, q = a.lo * b.hi, r = a.hi * b.lo, s = a.hi * b.hi;
  return outward(std::min(std::min(p, q), std::min(r, s)), std::max(std::max(p, q), std::max(r, s)));
}
Bounds operator/(Bounds a, Bounds b) {  // b > 0
  const double p = a.lo / b.lo, q = a.lo / b.hi, r = a.hi / b.lo, s = a.hi / b.hi;
  return outward(std::min(std::min(p, q), std::min(r, s)), std::max(std::max(p, q), std::max(r, s)));
}
Bounds root(Bounds x) {
  return outward(std::sqrt(x.lo), std::sqrt(x.hi));
}
Bounds point(double x) {
  return {x, x};
}

// ln 2 = high + low: n high is exact for |n| <= 2^11.
constexpr double kLn2High = 0x1.62e42fee00000p-1;
constexpr Bounds kLn2Low{0x1.a39ef35793c76p-33, 0x1.a39ef35793c77p-33};

}  // namespace

// e^x = 2^n e^r, |r| <= 0.35: Taylor's series to r^14, with a remainder below 2 |r|^15/15!.
Bounds exp_at(double x) {
  const double n = std::nearbyint(x * 1.4426950408889634);
  const Bounds reduced = (point(x) - point(n * kLn2High)) - point(n) * kLn2Low;
  Bounds sum = point(1);
  for (int k = 14; k >= 1; --k) sum = point(1) + reduced * sum / point(k);
  const double size = std::max(-reduced.lo, reduced.hi);
  double rest = 2 / 1.3e12;
  for (int k = 0; k < 15; ++k) rest *= size;
  const Bounds mantissa = sum + Bounds{-rest, rest};
  // In two steps: 2^n alone may be subnormal.
  const int whole = int(n), half = whole / 2;
  const Bounds scaled{std::ldexp(std::ldexp(mantissa.lo, half), whole - half),
                      std::ldexp(std::ldexp(mantissa.hi, half), whole - half)};
  return {std::max(outward(scaled.lo, scaled.lo).lo, 0.0), outward(scaled.hi, scaled.hi).hi};
}

namespace {

// log((1 + s)/(1 - s)) = 2 s (1 + s^2/3 + ...), |s| <= 0.18: to s^24, with a remainder below
// 1.04 s^26/27 < 2e-21.
Bounds log_series(Bounds s) {
  const Bounds z = s * s;
  Bounds sum = point(0);
  for (int k = 25; k >= 3; k -= 2) sum = (sum + point(1) / point(k)) * z;
  return point(2) * s * (point(1) + sum + Bounds{-2e-21, 2e-21});
}

}  // namespace

Bounds log_at(double x) {
  int e = 0;
  double m = std::frexp(x, &e);  // [1/2, 1)
  if (m < 0.70710678118654752) {
    m *= 2;
    --e;
  }
  // m - 1 is exact
  const Bounds s = point(m - 1) / (point(m) + point(1));
  const Bounds fraction = m == 1 ? point(0) : log_series(s);
  if (e == 0) return fraction;
  return point(e * kLn2High) + (point(e) * kLn2Low + fraction);
}

Bounds log1p_at(double x) {
  if (x == 0) return point(0);
  if (std::fabs(x) < 0.3) return log_series(point(x) / (point(2) + point(x)));
  const Bounds sum = point(1) + point(x);
  if (sum.lo <= 0) return {-745, log_at(sum.hi).hi};  // no double is nearer to -1
  return {log_at(sum.lo).lo, log_at(sum.hi).hi};
}

// For x < 1 uses e^(x^2) - 2/sqrt(pi) sum of 2^n x^(2n+1)/(2n+1)!!, with terms of one sign. For larger x
// uses the continued fraction of Laplace. Its convergents lie on both sides in turn: the innermost x is set
// to x and to infinity.
Bounds erfcx_at(double x) {
  const Bounds root_pi = root({kPiBounds.lo, kPiBounds.hi});
  if (x < 1) {
    const Bounds z = point(2) * (point(x) * point(x));
    Bounds sum = point(1);  // Horner's rule over 40 terms: the remainder is below z^40/(3 5 ... 81) < 1e-40
    for (int k = 40; k >= 1; --k) sum = point(1) + z / point(2 * k + 1) * sum;
    const Bounds square = point(x) * point(x);
    const Bounds power{exp_at(square.lo).lo, exp_at(square.hi).hi};
    const Bounds rest = sum + Bounds{0, 1e-40};
    return power - point(2) / root_pi * point(x) * rest;
  }
  constexpr int kTerms = 160;
  Bounds inner = point(x);
  Bounds outer = point(x);
  for (int k = kTerms; k >= 1; --k) inner = point(x) + point(0.5 * k) / inner;
  for (int k = kTerms - 1; k >= 1; --k) outer = point(x) + point(0.5 * k) / outer;
  const Bounds a = point(1) / (root_pi * inner), b = point(1) / (root_pi * outer);
  return {std::min(a.lo, b.lo), std::max(a.hi, b.hi)};
}

namespace {

// atan t, 0 <= t <= 1: twice atan t = 2 atan(t/(1 + sqrt(1 + t^2))), then the series to t^31, with a
// remainder below t^33/33.
Bounds atan_at(Bounds t) {
  for (int k = 0; k < 2; ++k) t = t / (point(1) + root(point(1) + t * t));
  const Bounds z = t * t;
  Bounds sum = point(0);
  for (int k = 31; k >= 3; k -= 2)
    sum = ((k / 2) % 2 == 0 ? sum + point(1) / point(k) : sum - point(1) / point(k)) * z;
  const Bounds factor = point(1) + sum + Bounds{-1e-23, 1e-23};  // 0.2^32/33
  return point(4) * t * factor;
}

}  // namespace

Bounds angle_at(double sine, double cosine) {
  if (sine == 0) return point(0);
  const Bounds half{kPiBounds.lo / 2, kPiBounds.hi / 2};
  if (cosine == 0) return half;
  if (sine <= cosine) {
    const Bounds a = atan_at(point(sine) / point(cosine));
    return {std::max(a.lo, 0.0), a.hi};
  }
  const Bounds a = half - atan_at(point(cosine) / point(sine));
  return {a.lo, std::min(a.hi, half.hi)};
}

// Taylor's series to x^26, with a remainder below x^27/27! < 3e-23.
Bounds sin_at(double x) {
  const Bounds square = point(x) * point(x);
  Bounds sum = point(1);
  for (int k = 25; k >= 3; k -= 2) sum = point(1) - square / point(k * (k - 1)) * sum;
  return point(x) * (sum + Bounds{-3e-23, 3e-23});
}
Bounds cos_at(double x) {
  const Bounds square = point(x) * point(x);
  Bounds sum = point(1);
  for (int k = 26; k >= 2; k -= 2) sum = point(1) - square / point(k * (k - 1)) * sum;
  return sum + Bounds{-3e-23, 3e-23};
}

}  // namespace brdf::prove
