// The extended type of the processor (long double) as a scalar of the forms. On x86-64 it has eleven bits
// more than double, which gives a rounding error of double to about a thousandth, and it is a hundred times
// faster than 50 digits. If long double is no more precise than double, the first look of Rounding would
// see no error at all; in this case Extended is not used there.
#pragma once

#include <cmath>
#include <compare>
#include <limits>
#include <type_traits>

namespace brdf::validate {

struct Extended {
  long double value = 0;

  Extended() = default;
  template <class Number>
    requires std::is_arithmetic_v<Number>
  explicit(false) Extended(Number x) : value(x) {}
  explicit operator double() const { return static_cast<double>(value); }

  friend Extended operator-(const Extended& x) { return -x.value; }
  friend Extended operator+(const Extended& a, const Extended& b) { return a.value + b.value; }
  friend Extended operator-(const Extended& a, const Extended& b) { return a.value - b.value; }
  friend Extended operator*(const Extended& a, const Extended& b) { return a.value * b.value; }
  friend Extended operator/(const Extended& a, const Extended& b) { return a.value / b.value; }
  Extended& operator+=(const Extended& b) { return *this = *this + b; }
  Extended& operator-=(const Extended& b) { return *this = *this - b; }
  Extended& operator*=(const Extended& b) { return *this = *this * b; }
  friend auto operator<=>(const Extended& a, const Extended& b) = default;

  // The forms find these overloads through argument-dependent lookup.
  friend Extended abs(const Extended& x) { return std::abs(x.value); }
  friend Extended sqrt(const Extended& x) { return std::sqrt(x.value); }
  friend Extended exp(const Extended& x) { return std::exp(x.value); }
  friend Extended log(const Extended& x) { return std::log(x.value); }
  friend Extended log1p(const Extended& x) { return std::log1p(x.value); }
  friend Extended atan2(const Extended& y, const Extended& x) { return std::atan2(y.value, x.value); }
  // Beyond x = 100 exp(x^2) may overflow, so the asymptotic value 1/(x sqrt(pi)) is used. There the forms
  // multiply it with exp(-x^2), and the product is negligible next to other terms.
  friend Extended erfcx(const Extended& x) {
    constexpr long double kRootPi = 1.7724538509055160273L;
    return x.value > 100 ? 1 / (x.value * kRootPi) : std::exp(x.value * x.value) * std::erfc(x.value);
  }
};

inline constexpr bool kExtendedIsFiner =
    std::numeric_limits<long double>::digits >= std::numeric_limits<double>::digits + 10;

}  // namespace brdf::validate
