// Intervals: every value that a formula can take on a box, in exact arithmetic and rounded in Base.
//
// Each operation is widened by one unit in the last place of Base. The interval then holds the exact result
// and the result that a program of that precision computes, however it rounds to nearest. There are no
// rounding modes, and no branches on data that would prevent vectorisation. Exact zeros stay exact, and
// results that cannot be negative stay so. An interval that may hold an infinity, a NaN, or a quotient by a
// subnormal is `poisoned`, and so are all results that depend on it. Therefore a result that is finite was
// finite in all steps. The value of a box is right only with contraction off and without -ffast-math.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "brdf/scalar.h"
#include "prove/scalar/elementary.h"

namespace brdf::prove {

enum class Tri { no, yes, maybe };

template <class Base>
class Interval {
 public:
  static constexpr bool kSingle = std::is_same_v<Base, float>;
  static constexpr double kUnit = kSingle ? 0x1.00001p-23 : 0x1p-52;  // relative, of one rounding
  static constexpr double kTiny = kSingle ? 0x1p-148 : 0x1p-1074;     // absolute, below the normal range
  static constexpr double kSmallest = double(std::numeric_limits<Base>::min());
  static constexpr double kLargest = double(std::numeric_limits<Base>::max());

  double lo = 0, hi = 0;

  constexpr Interval() = default;
  // Rounds the constant to Base. Poisoned if the constant is infinite, NaN, or out of the range of Base.
  constexpr explicit Interval(double constant) {
    const double rounded = double(Base(constant));
    const bool finite = rounded >= -kLargest && rounded <= kLargest;
    lo = finite ? rounded : -std::numeric_limits<double>::infinity();
    hi = finite ? rounded : std::numeric_limits<double>::infinity();
  }
  // Returns [low, high], low <= high; poisoned if one of them is out of the range of Base.
  static Interval of(double low, double high) {
    Interval r;
    const bool within = low >= -kLargest && high <= kLargest;  // false for NaN too
    r.lo = within ? low : -std::numeric_limits<double>::infinity();
    r.hi = within ? high : std::numeric_limits<double>::infinity();
    return r;
  }
  static Interval poison() { return of(-std::numeric_limits<double>::infinity(), 0); }
  // Returns [low, high] widened by `units` roundings of Base. Bounds of one sign keep their sign.
  static Interval widened(double low, double high, double units = 1) {
    const double below = low - (std::fabs(low) * (units * kUnit) + kTiny);
    const double above = high + (std::fabs(high) * (units * kUnit) + kTiny);
    return of(low >= 0 ? std::max(below, 0.0) : below, high <= 0 ? std::min(above, 0.0) : above);
  }

  bool poisoned() const { return !(lo >= -kLargest); }
  bool is(double x) const { return lo == x && hi == x; }
  double magnitude() const { return std::max(-lo, hi); }

  friend Interval operator-(const Interval& x) { return of(-x.hi, -x.lo); }
  friend Interval operator+(const Interval& a, const Interval& b) {
    if (b.is(0)) return a;
    if (a.is(0)) return b;
    Interval r = widened(a.lo + b.lo, a.hi + b.hi);
    return keep(r, b.lo >= 0 ? a.lo : r.lo, b.hi <= 0 ? a.hi : r.hi);
  }
  friend Interval operator-(const Interval& a, const Interval& b) {
    if (b.is(0)) return a;
    Interval r = widened(a.lo - b.hi, a.hi - b.lo);
    return keep(r, b.hi <= 0 ? a.lo : r.lo, b.lo >= 0 ? a.hi : r.hi);
  }
  friend Interval operator*(const Interval& a, const Interval& b) {
    if (a.poisoned() || b.poisoned()) return poison();
    if (a.is(0) || b.is(0)) return Interval();
    if (b.is(1)) return a;
    if (a.is(1)) return b;
    if (&a == &b) return square(a);
    const double p = a.lo * b.lo, q = a.lo * b.hi, r = a.hi * b.lo, s = a.hi * b.hi;
    return signed_product(std::min(std::min(p, q), std::min(r, s)), std::max(std::max(p, q), std::max(r, s)),
                          a, b);
  }
  friend Interval operator/(const Interval& a, const Interval& b) {
    if (a.poisoned() || b.poisoned() || (b.lo < kSmallest && b.hi > -kSmallest)) return poison();
    if (a.is(0)) return Interval();
    const double p = a.lo / b.lo, q = a.lo / b.hi, r = a.hi / b.lo, s = a.hi / b.hi;
    return signed_product(std::min(std::min(p, q), std::min(r, s)), std::max(std::max(p, q), std::max(r, s)),
                          a, b);
  }
  friend Tri operator<(const Interval& a, const Interval& b) {
    if (a.poisoned() || b.poisoned()) return Tri::maybe;
    return a.hi < b.lo ? Tri::yes : a.lo >= b.hi ? Tri::no : Tri::maybe;
  }

  friend Interval hull(const Interval& a, const Interval& b) {
    return of(std::min(a.lo, b.lo), std::max(a.hi, b.hi));
  }
  friend Interval select(Tri condition, const Interval& yes, const Interval& no) {
    return condition == Tri::yes ? yes : condition == Tri::no ? no : hull(yes, no);
  }
  // In the library NaN passes through these functions; therefore poison does here.
  friend Interval larger(const Interval& a, const Interval& b) {
    return a.poisoned() || b.poisoned() ? poison() : of(std::max(a.lo, b.lo), std::max(a.hi, b.hi));
  }
  friend Interval smaller(const Interval& a, const Interval& b) {
    return a.poisoned() || b.poisoned() ? poison() : of(std::min(a.lo, b.lo), std::min(a.hi, b.hi));
  }
  friend Interval at_least(const Interval& x, const Interval& lower) { return larger(x, lower); }
  friend Interval at_most(const Interval& x, const Interval& upper) { return smaller(x, upper); }
  friend Interval square(const Interval& x) {
    const double p = x.lo * x.lo, q = x.hi * x.hi;
    return widened(x.lo < 0 && x.hi > 0 ? 0 : std::min(p, q), std::max(p, q));
  }
  // Encloses the rounding error of a sum: at most half a unit of the sum.
  friend Interval sum_rest(const Interval&, const Interval&, const Interval& sum) {
    return of(-kUnit * sum.magnitude(), kUnit * sum.magnitude());
  }

  friend Interval sqrt(const Interval& x) {
    if (x.poisoned() || x.lo < 0) return poison();
    return widened(std::sqrt(x.lo), std::sqrt(x.hi));
  }
  // The stated errors of the kernels are at most 2 units (brdf/kernels.h); these functions allow more than
  // twice that.
  friend Interval exp(const Interval& x) {
    constexpr double lowest = kSingle ? -80 : -690, highest = kSingle ? 88 : 709;  // below: 0; above: clamped
    if (x.poisoned() || x.hi > highest) return poison();
    const double low = x.lo <= lowest ? 0 : exp_at(x.lo).lo;
    return widened(low, exp_at(std::max(x.hi, -745.0)).hi, kKernelUnits);
  }
  friend Interval log(const Interval& x) {
    if (x.poisoned() || x.lo < kSmallest) return poison();
    return widened(log_at(x.lo).lo, log_at(x.hi).hi, kKernelUnits);
  }
  friend Interval log1p(const Interval& x) {
    if (x.poisoned() || x.lo <= -1) return poison();
    return widened(log1p_at(x.lo).lo, log1p_at(x.hi).hi, kKernelUnits);
  }
  friend Interval erfcx(const Interval& x) {
    if (x.poisoned() || x.lo < 0 || x.hi > 10.5) return poison();
    return widened(erfcx_at(x.hi).lo, erfcx_at(x.lo).hi, 2 * kKernelUnits);
  }
  friend Interval atan2(const Interval& sine, const Interval& cosine) {
    if (sine.poisoned() || cosine.poisoned() || sine.lo < 0 || cosine.lo < 0 ||
        std::max(sine.lo, cosine.lo) < kSmallest)
      return poison();
    return widened(angle_at(sine.lo, cosine.hi).lo, angle_at(sine.hi, cosine.lo).hi, kKernelUnits);
  }

  static constexpr double kKernelUnits = 4;

 private:
  // Adding to x, or subtracting from x, a number of known sign cannot carry the result past x, rounded or
  // exact.
  static Interval keep(const Interval& r, double low, double high) {
    return r.poisoned() ? r : of(std::max(r.lo, low), std::min(r.hi, high));
  }
  // Underflow must not change the sign of a product that can have only one sign.
  static Interval signed_product(double low, double high, const Interval& a, const Interval& b) {
    Interval r = widened(low, high);
    if (r.poisoned()) return r;
    const bool same = (a.lo >= 0 && b.lo >= 0) || (a.hi <= 0 && b.hi <= 0);
    const bool opposite = (a.lo >= 0 && b.hi <= 0) || (a.hi <= 0 && b.lo >= 0);
    if (same) r.lo = std::max(r.lo, 0.0);
    if (opposite) r.hi = std::min(r.hi, 0.0);
    return r;
  }
};

}  // namespace brdf::prove

namespace brdf {

template <class Base>
struct BaseScalar<prove::Interval<Base>> {
  using type = Base;
};

}  // namespace brdf
