// Angles with an explicit unit. An Angle is constructed from degrees or from radians by a named function,
// and its value is read by a named function, so that the units cannot be confused.
#pragma once

#include <compare>

#include "brdf/scalar.h"

namespace brdf {

class Angle {
 public:
  constexpr Angle() = default;
  static constexpr Angle from_radians(double x) { return Angle(x); }
  static constexpr Angle from_degrees(double x) { return Angle(x * (kPi / 180)); }
  constexpr double radians() const { return radians_; }
  constexpr double degrees() const { return radians_ / (kPi / 180); }

  friend constexpr Angle operator+(Angle a, Angle b) { return Angle(a.radians_ + b.radians_); }
  friend constexpr Angle operator-(Angle a, Angle b) { return Angle(a.radians_ - b.radians_); }
  friend constexpr Angle operator-(Angle a) { return Angle(-a.radians_); }
  friend constexpr Angle operator*(double s, Angle a) { return Angle(s * a.radians_); }
  friend constexpr Angle operator*(Angle a, double s) { return s * a; }
  friend constexpr Angle operator/(Angle a, double s) { return Angle(a.radians_ / s); }
  friend constexpr auto operator<=>(Angle, Angle) = default;

 private:
  explicit constexpr Angle(double x) : radians_(x) {}
  double radians_ = 0;
};

constexpr Angle radians(double x) {
  return Angle::from_radians(x);
}
constexpr Angle degrees(double x) {
  return Angle::from_degrees(x);
}

inline namespace literals {
constexpr Angle operator""_deg(long double x) {
  return degrees(double(x));
}
constexpr Angle operator""_deg(unsigned long long x) {
  return degrees(double(x));
}
}  // namespace literals

}  // namespace brdf
