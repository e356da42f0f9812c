// The effect of rounding on a formula: the range of its exact value on a box, and bounds of the error of
// the value that Base computes.
//
// The exact value is the formula in real numbers at the stored inputs, with constants in double. For the
// computed x^:
//   |x^ - x| <= relative.error |x| + relative.underflow,
//   |x^ - x| <= peak.error E + peak.underflow,
//   |x^ - x| <= absolute.
// E >= |x| is x with the factors that have no proved relative error at their largest values (Fresnel's
// weight and Gaussians at 1) and all other factors unchanged.
//
// Any of the bounds may be infinite, which claims nothing. The model of a rounding is that of IEEE: a
// factor (1 + d), with |d| <= u, and half a subnormal if a product may leave the normal range. Absence of
// overflow is shown by `finite`. The bounds themselves are rounded up.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "prove/scalar/interval.h"

namespace brdf::prove {

// A comparison. either: the computed numbers have the order of the exact numbers, but the order is open.
// unknown: the orders may differ.
enum class Choice { no, yes, either, unknown };

template <class Base>
class Rounded {
 public:
  using I = Interval<Base>;
  static constexpr double kUnit = I::kSingle ? 0x1p-24 : 0x1p-53;
  static constexpr double kTiny = I::kSingle ? 0x1p-149 : 0x1p-1070;
  static constexpr double kNever = std::numeric_limits<double>::infinity();

  struct Bound {
    double error = 0, underflow = 0;
    bool known() const { return error < kNever; }
  };

  Bounds range{0, 0};
  Bound relative{}, peak{};
  Bounds envelope{0, 0};  // bounds of E
  double absolute = 0;

  Rounded() = default;
  explicit Rounded(double constant) : range{constant, constant} {
    const double error = std::fabs(double(Base(constant)) - constant);
    absolute = error;
    relative.error = error == 0 ? 0 : up(error / std::fabs(constant));
    settle_peak();
  }
  // Returns an input, which is exact as stored.
  static Rounded of(double low, double high) {
    Rounded r;
    r.range = {low, high};
    r.settle_peak();
    return r;
  }
  static Rounded unknown() {
    Rounded r;
    r.range = {-kNever, kNever};
    r.relative.error = r.peak.error = r.absolute = kNever;
    return r;
  }
  // Returns a value that is known relative to itself.
  static Rounded within(Bounds range, double error, double underflow = 0) {
    Rounded r;
    r.range = range;
    r.relative = {error, underflow};
    r.peak.error = r.absolute = kNever;
    return r.finished();
  }
  // Returns a value with the given envelope as E.
  static Rounded beside(Bounds range, double error, Bounds envelope) {
    Rounded r;
    r.range = range;
    r.relative.error = r.absolute = kNever;
    r.peak.error = error;
    r.envelope = envelope;
    return r.finished();
  }

  bool exact() const { return absolute == 0; }
  double least() const { return range.lo > 0 ? range.lo : range.hi < 0 ? -range.hi : 0; }  // the least |x|
  double most() const { return std::max(-range.lo, range.hi); }
  // Returns the range of the computed values.
  Bounds computed() const {
    Bounds c{range.lo - absolute, range.hi + absolute};
    if (relative.error < 1 && relative.underflow == 0) {  // the sign is kept
      if (range.lo >= 0) c.lo = std::max(c.lo, range.lo * (1 - relative.error) * (1 - 0x1p-50));
      if (range.hi <= 0) c.hi = std::min(c.hi, range.hi * (1 - relative.error) * (1 - 0x1p-50));
    }
    return c;
  }

  friend Rounded operator-(const Rounded& x) {
    Rounded r = x;
    r.range = {-x.range.hi, -x.range.lo};
    return r;
  }
  friend Rounded operator+(const Rounded& a, const Rounded& b) {
    if (b.is(0)) return a;
    if (a.is(0)) return b;
    Rounded r = unknown();
    r.range = outward(a.range.lo + b.range.lo, a.range.hi + b.range.hi);
    if (a.range.lo >= 0 && b.range.lo >= 0)
      r.range.lo = std::max(r.range.lo, std::max(a.range.lo, b.range.lo));
    if (a.range.hi <= 0 && b.range.hi <= 0)
      r.range.hi = std::min(r.range.hi, std::min(a.range.hi, b.range.hi));
    const bool same = (a.range.lo >= 0 && b.range.lo >= 0) || (a.range.hi <= 0 && b.range.hi <= 0);
    if (same || (a.exact() && b.exact()))
      r.relative = then_rounded(
          {std::max(a.relative.error, b.relative.error), up(a.relative.underflow + b.relative.underflow)}, 0);
    r.peak = then_rounded({std::max(a.peak.error, b.peak.error), up(a.peak.underflow + b.peak.underflow)}, 0);
    r.envelope = outward(a.envelope.lo + b.envelope.lo, a.envelope.hi + b.envelope.hi);
    r.absolute = up((a.absolute + b.absolute) * (1 + kUnit) + kUnit * r.most());
    return r.finished();
  }
  friend Rounded operator-(const Rounded& a, const Rounded& b) { return a + -b; }
  friend Rounded operator*(const Rounded& a, const Rounded& b) {
    if (&a == &b) return square(a);
    if (a.is(0) || b.is(0)) return Rounded();
    if (b.is(1)) return a;
    if (a.is(1)) return b;
    const double p = a.range.lo * b.range.lo, q = a.range.lo * b.range.hi, s = a.range.hi * b.range.lo,
                 t = a.range.hi * b.range.hi;
    return product(
        a, b, outward(std::min(std::min(p, q), std::min(s, t)), std::max(std::max(p, q), std::max(s, t))));
  }
  friend Rounded square(const Rounded& x) {
    const double low = x.least(), high = x.most();
    return product(x, x, {low * low * (1 - 0x1p-50), up(high * high)});
  }
  // The divisor must be known relative to itself.
  friend Rounded operator/(const Rounded& a, const Rounded& b) {
    const double low = b.least() * (1 - b.relative.error);
    if (a.is(0) && low > 0) return Rounded();
    if (!(low > I::kSmallest) || b.relative.underflow > 0) return unknown();
    const double p = a.range.lo / b.range.lo, q = a.range.lo / b.range.hi, s = a.range.hi / b.range.lo,
                 t = a.range.hi / b.range.hi;
    Rounded r = unknown();
    r.range = outward(std::min(std::min(p, q), std::min(s, t)), std::max(std::max(p, q), std::max(s, t)));
    if (a.range.lo >= 0 && b.range.lo > 0) r.range.lo = std::max(r.range.lo, 0.0);
    const double half = half_of_subnormal(up(a.most() / b.least()), a.least() / b.most());
    const auto over = [&](const Bound& n) {
      return Bound{up((n.error + b.relative.error) / (1 - b.relative.error)), up(n.underflow / low)};
    };
    r.relative = then_rounded(over(a.relative), half);
    r.peak = then_rounded(over(a.peak), half);
    r.envelope = outward(a.envelope.lo / b.most(), a.envelope.hi / b.least());
    r.absolute = up((a.absolute / low + r.most() * b.relative.error / (1 - b.relative.error)) * (1 + kUnit) +
                    kUnit * r.most() + half);
    return r.finished();
  }
  friend Choice operator<(const Rounded& a, const Rounded& b) {
    const Bounds x = a.computed(), y = b.computed();
    if (std::max(x.hi, a.range.hi) < std::min(y.lo, b.range.lo)) return Choice::yes;
    if (std::min(x.lo, a.range.lo) >= std::max(y.hi, b.range.hi)) return Choice::no;
    return a.exact() && b.exact() ? Choice::either : Choice::unknown;
  }
  friend Rounded select(Choice choice, const Rounded& yes, const Rounded& no) {
    if (choice == Choice::yes) return yes;
    if (choice == Choice::no) return no;
    if (choice == Choice::unknown) return unknown();
    Rounded r = worse(yes, no);
    r.range = {std::min(yes.range.lo, no.range.lo), std::max(yes.range.hi, no.range.hi)};
    r.envelope = {std::min(yes.envelope.lo, no.envelope.lo), std::max(yes.envelope.hi, no.envelope.hi)};
    return r.finished();
  }
  // The error |max(a^, b^) - max(a, b)| is at most the larger error, and max(E_a, E_b) is at least |max(a,
  // b)|.
  friend Rounded larger(const Rounded& a, const Rounded& b) {
    Rounded r = extreme(a, b);
    r.range = {std::max(a.range.lo, b.range.lo), std::max(a.range.hi, b.range.hi)};
    r.envelope = {std::max(a.envelope.lo, b.envelope.lo), std::max(a.envelope.hi, b.envelope.hi)};
    return r.finished();
  }
  friend Rounded smaller(const Rounded& a, const Rounded& b) {
    Rounded r = extreme(a, b);
    r.range = {std::min(a.range.lo, b.range.lo), std::min(a.range.hi, b.range.hi)};
    r.peak = {kNever, 0};
    return r.finished();
  }
  friend Rounded at_least(const Rounded& x, const Rounded& lower) { return larger(x, lower); }
  friend Rounded at_most(const Rounded& x, const Rounded& upper) { return smaller(x, upper); }
  // 0 in exact arithmetic. Its effect is covered by lemmas for the functions that use it
  // (rounding_lemmas.h).
  friend Rounded sum_rest(const Rounded&, const Rounded&, const Rounded& sum) {
    Rounded r = unknown();
    r.range = {0, 0};
    r.absolute = up(kUnit * (sum.most() + sum.absolute));
    return r;
  }

  friend Rounded sqrt(const Rounded& x) {
    if (!(x.range.lo >= 0) || x.computed().lo < 0) return unknown();
    Rounded r = unknown();
    r.range = {std::sqrt(x.range.lo) * (1 - 0x1p-50), up(std::sqrt(x.range.hi))};
    // 1 - sqrt(1 - e) <= e/2/(1 - e)
    if (x.relative.error < 0.5 && x.relative.underflow == 0)
      r.relative = then_rounded({up(x.relative.error / 2 / (1 - x.relative.error)), 0}, 0);
    return r.finished();
  }
  // For x <= 0 with a relative error e, the error relative to the peak 1 is at most
  // sup_y exp(-y) (exp(e y) - 1) <= e/(1 - e) exp(-1), plus the results that are flushed to 0.
  friend Rounded exp(const Rounded& x) {
    constexpr double lowest = I::kSingle ? -80 : -690, highest = I::kSingle ? 88 : 709;
    if (!(x.range.hi + x.absolute <= highest))
      if (!(x.range.hi <= 0 && x.relative.known())) return unknown();
    Rounded r = unknown();
    r.range = {x.range.lo <= -745 ? 0 : exp_at(x.range.lo).lo, exp_at(std::max(x.range.hi, -745.0)).hi};
    if (x.range.lo - x.absolute > lowest && x.absolute < 0.25)
      r.relative = {up(x.absolute * (1 + x.absolute) * (1 + kKernel) + kKernel), 0};
    if (x.range.hi <= 0 && x.relative.error < 0.1) {
      const double e = x.relative.error;
      r.peak = {
          up(e / (1 - e) * 0.36788 + kKernel + (I::kSingle ? 1.9e-35 : 1e-299) + 2 * x.relative.underflow),
          0};
      r.envelope = {1, 1};
    }
    return r.finished();
  }
  // (1 + e) x has at most (1 + e) times the logarithm of x, and (1 - e) x at least (1 - e) times, since
  // log1p is concave.
  friend Rounded log1p(const Rounded& x) {
    if (!(x.range.lo >= 0 && x.relative.error < 0.5)) return unknown();
    return within({log1p_at(x.range.lo).lo, log1p_at(x.range.hi).hi}, up(x.relative.error + 2 * kKernel),
                  x.relative.underflow);
  }
  friend Rounded log(const Rounded&) { return unknown(); }
  friend Rounded erfcx(const Rounded&) { return unknown(); }
  friend Rounded atan2(const Rounded&, const Rounded&) { return unknown(); }

  // The error of the library's kernels, measured at 1 to 2 units of two roundings each; the same bound as
  // for intervals.
  static constexpr double kKernel = I::kKernelUnits * 2 * kUnit;
  static double up(double x) { return x * (1 + 0x1p-50); }

  bool is(double x) const { return range.lo == x && range.hi == x && exact(); }

  // Improves each bound by the others.
  Rounded finished() const {
    Rounded r = *this;
    const double least = r.least(), most = r.most();
    if (!(most < 1e300) || !(range.lo <= range.hi)) return unknown();
    if (!(r.absolute <= kNever)) r.absolute = kNever;  // NaN, from 0 times infinity
    if (r.relative.known())
      r.absolute = std::min(r.absolute, up(r.relative.error * most + r.relative.underflow));
    if (r.peak.known())
      r.absolute = std::min(r.absolute, up(r.peak.error * r.envelope.hi + r.peak.underflow));
    if (least > 0) {
      absorb(r.relative, least);
      if (r.absolute / least < r.relative.error) r.relative = {up(r.absolute / least), 0};
    }
    if (r.peak.known() && r.envelope.lo > 0) absorb(r.peak, r.envelope.lo);
    if (!r.peak.known() && r.absolute < kNever) {
      r.peak = {most > 0 ? up(r.absolute / most) : 0, 0};
      r.envelope = {most, most};
    }
    if (r.relative.error <= r.peak.error) r.settle_peak();
    return r;
  }

 private:
  static Bounds outward(double low, double high) {
    return {low - std::fabs(low) * 0x1p-50, high + std::fabs(high) * 0x1p-50};
  }
  // Adds the underflow to the relative error of a value that is never smaller than `least`.
  static void absorb(Bound& b, double least) {
    if (b.underflow == 0 || !(b.underflow / least < 0x1p-10 * kUnit)) return;
    b = {up(b.error + b.underflow / least), 0};
  }
  // Sets E to |x|.
  void settle_peak() {
    peak = relative;
    envelope = {least(), most()};
  }
  static Bound then_rounded(const Bound& b, double half) {
    return {up(b.error + kUnit + b.error * kUnit), up(b.underflow * (1 + kUnit) + half)};
  }
  static double half_of_subnormal(double, double least) {
    return least >= I::kSmallest * (1 + 1e-6) ? 0 : kTiny;
  }
  static Rounded product(const Rounded& a, const Rounded& b, Bounds range) {
    Rounded r = unknown();
    r.range = range;
    if (a.range.lo >= 0 && b.range.lo >= 0) r.range.lo = std::max(r.range.lo, 0.0);
    const double half = half_of_subnormal(r.most(), a.least() * b.least());
    const auto both = [&](const Bound& x, const Bound& y) {
      return Bound{up(x.error + y.error + x.error * y.error),
                   up(x.underflow * b.most() * (1 + y.error) + y.underflow * a.most() * (1 + x.error) +
                      x.underflow * y.underflow)};
    };
    r.relative = guarded(then_rounded(both(a.relative, b.relative), half));
    r.peak = guarded(then_rounded(both(a.peak, b.peak), half));
    r.envelope = outward(a.envelope.lo * b.envelope.lo, a.envelope.hi * b.envelope.hi);
    const double before = a.absolute * b.most() + b.absolute * a.most() + a.absolute * b.absolute;
    r.absolute = up(before * (1 + kUnit) + kUnit * r.most() + half);
    return r.finished();
  }
  // 0 times infinity is NaN: nothing is claimed.
  static Bound guarded(const Bound& b) {
    return b.error < kNever && b.underflow < kNever ? b : Bound{kNever, 0};
  }
  static Rounded worse(const Rounded& a, const Rounded& b) {
    Rounded r;
    const auto worst = [](const Bound& x, const Bound& y) {
      return Bound{std::max(x.error, y.error), std::max(x.underflow, y.underflow)};
    };
    r.relative = worst(a.relative, b.relative);
    r.peak = worst(a.peak, b.peak);
    r.absolute = std::max(a.absolute, b.absolute);
    return r;
  }
  // Numbers of both signs keep no relative error: the smaller one may be taken instead of the other.
  static Rounded extreme(const Rounded& a, const Rounded& b) {
    Rounded r = worse(a, b);
    const bool signless = a.range.lo >= 0 && b.range.lo >= 0;
    if (!signless && !(a.exact() && b.exact())) r.relative = {kNever, 0};
    return r;
  }
};

}  // namespace brdf::prove

namespace brdf {

template <class Base>
struct BaseScalar<prove::Rounded<Base>> {
  using type = Base;
};

}  // namespace brdf
