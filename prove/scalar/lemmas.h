// Facts that intervals cannot derive operation by operation: enclosures of parts of the library in which
// the same quantity occurs twice. Each is an overload that the unchanged forms select by its argument type.
// Its reason is given with it, and tests compare it with millions of evaluations in both precisions.
//
// u is one unit of Base, Interval::kUnit: two roundings.
#pragma once

#include "brdf/forms.h"
#include "prove/scalar/interval.h"

namespace brdf::prove {

// Returns [low, high] cut to bounds that are known otherwise. Precondition: the two ranges meet.
template <class B>
Interval<B> cut(const Interval<B>& x, double low, double high) {
  if (x.poisoned()) return x;
  return Interval<B>::of(std::min(std::max(x.lo, low), high), std::max(std::min(x.hi, high), low));
}

// The largest relative difference between the rounded and the exact value of an exponent, in units. The
// exponent has fewer than a dozen roundings, and the separately carried rest is as small.
inline constexpr double kExponentUnits = 32;

// exp(-e) (1 - rest), |rest| <= 32 u e. If e is beyond the range of the kernel, exp is 0, and so is its
// product with the rest.
template <class B>
Interval<B> gaussian_of(const Interval<B>& e) {
  using I = Interval<B>;
  const I gaussian = exp(-e);
  const double reach = I::kSingle ? 80 : 690;
  const double rest = kExponentUnits * I::kUnit * std::min(e.hi, reach);
  return gaussian.poisoned()
             ? gaussian
             : I::widened(gaussian.lo * (1 - rest), gaussian.hi * (1 + rest), 2 * I::kKernelUnits);
}

// The exponent is a sum of squares over a square.
template <class B>
Interval<B> slope_gaussian(const Roughness<Interval<B>>& a, const Geometry<Interval<B>>& g,
                           const Interval<B>& inverse, const TwoPart<Interval<B>>&) {
  return gaussian_of(scaled_tangent2(a, g) * inverse);
}

// A fraction with an upper bound of its value that its terms alone do not show.
template <class B>
struct BoundedFraction : Fraction<Interval<B>> {
  double highest;
};

// D of GGX. |h|^2 is at most max(1, w^2) times its stretched square q, where w is the larger width.
// Therefore D is at most max(1, w^4)/(pi alpha_x alpha_y).
template <class B>
BoundedFraction<B> d_ggx(const Roughness<Interval<B>>& a, const Geometry<Interval<B>>& g) {
  using I = Interval<B>;
  const I q = scaled_tangent2(a, g) + square(g.h.z), area = I(kPi) * a.alpha_x * a.alpha_y;
  const double width = std::max({1.0, a.alpha_x.hi, a.alpha_y.hi});
  const double highest = width * width * width * width / area.lo * (1 + 64 * I::kUnit);
  return {{I(kDenominatorScale) * square(g.h2), I(kPi * kDenominatorScale) * a.alpha_x * a.alpha_y * (q * q)},
          highest};
}
template <class B>
Interval<B> quotient(const BoundedFraction<B>& d, const Fraction<Interval<B>>& v) {
  using I = Interval<B>;
  const I numerator = d.num * v.num, denominator = d.den * v.den, factor = v.num / v.den;
  if (numerator.poisoned() || factor.poisoned() || denominator.lo < I::kSmallest) return I::poison();
  const double highest = d.highest * factor.hi * (1 + 64 * I::kUnit);
  return I::of(std::max(0.0, numerator.lo / denominator.hi * (1 - 4 * I::kUnit) - I::kTiny),
               std::min(numerator.hi / denominator.lo * (1 + 4 * I::kUnit) + I::kTiny, highest));
}

// (1 + tan^2)^2 e^(-tan^2 scaled). The widths of every form are at most 1. Therefore the numerator is at
// most r^2 e^(-(r - 1)/w^2), with r = 1 + tan^2 and the larger width w. This bound increases up to
// r = 2 w^2 and then decreases. (For scaled widths above 1 the product of both factors is used.)
template <class B>
Fraction<Interval<B>> d_beckmann(const Roughness<Interval<B>>& a, const Geometry<Interval<B>>& g) {
  using I = Interval<B>;
  const I inverse = I(1) / square(g.h.z), r = g.h2 * inverse;
  I numerator = slope_gaussian(a, g, inverse, TwoPart<I>{}) * square(r);
  const double width2 = std::max(a.alpha_x.hi * a.alpha_x.hi, a.alpha_y.hi * a.alpha_y.hi);
  if (width2 <= 1 && !r.poisoned()) {
    // At most e^(1/w^2) (2 w^2)^2 e^(-2) for any r >= 1. The largest value is at w = 1: 4/e = 1.4716.
    const double at = std::max(r.lo, 2.0);
    const double highest = r.lo <= 2 ? 1.4717 : at * at * exp_at(-std::min((at - 1) * (1 - 1e-5), 700.0)).hi;
    numerator = cut(numerator, 0, highest * (1 + 1e-3) + I::kTiny);
  }
  return {numerator, I(kPi) * a.alpha_x * a.alpha_y};
}

// (n.h)^n = exp(-n/2 log(1 + tan^2)). The rest changes the logarithm by at most 32 u relative.
template <class B>
Interval<B> half_cosine_power(const Interval<B>& n, const Geometry<Interval<B>>& g) {
  using I = Interval<B>;
  const I sine2 = square(g.h.x) + square(g.h.y), tan2 = sine2 * (I(1) / square(g.h.z));
  const I logarithm = log1p(tan2);
  if (logarithm.poisoned()) return logarithm;
  return exp(n * (I(-0.5) * I::widened(std::max(logarithm.lo, 0.0), logarithm.hi, kExponentUnits)));
}

// (r.o)^n from t = 1 - r.o < 1. The rest is at most 8 u t, and changes the logarithm by that over 1 - t. 1
// - t is at least half a unit if t is below 1, so that the change is at most 16. The logarithm is not
// positive, so the power is at most 1.
template <class B>
Interval<B> mirror_cosine_power(const Interval<B>& n, const Geometry<Interval<B>>& g) {
  using I = Interval<B>;
  const I apart = g.cos_i - g.cos_o, t = I(0.5) * (square(g.h.x) + square(g.h.y) + square(apart));
  if (t.poisoned() || n.poisoned()) return I::poison();
  const double last = 1 - I::kUnit / 2;  // the largest t below 1
  if (t.lo >= 1) return I();
  const double low = std::min(t.lo, last), high = std::min(t.hi, last);
  const auto moved = [](double x) { return 8 * I::kUnit * x / (1 - x) * 1.01; };
  const double least = log1p_at(-high).lo, most = log1p_at(-low).hi;
  const I logarithm =
      I::widened(least * (1 + 1e-6) - moved(high), std::min(0.0, most * (1 - 8 * I::kUnit) + moved(low)), 8);
  const I power = cut(exp(n * logarithm), 0, 1 + 8 * I::kUnit);
  return t.hi < 1 ? power : hull(power, I());
}

// sin^2 = 1 - cos^2 for a direction, stored to 2 units.
template <class B>
Interval<B> sine(const Vec3<Interval<B>>& w) {
  using I = Interval<B>;
  const I by_parts = sqrt(square(w.x) + square(w.y));
  const double z_low = std::max(w.z.lo * (1 - 4 * I::kUnit), 0.0),
               z_high = std::min(w.z.hi * (1 + 4 * I::kUnit), 1.0);
  const I by_height = I::widened(std::sqrt(std::max((1 - z_high) * (1 + z_high), 0.0)),
                                 std::sqrt((1 - std::min(z_low, 1.0)) * (1 + z_low)), 8);
  return cut(by_parts, by_height.lo, std::max(by_height.hi, by_height.lo));
}

// A form's choice by the sign of s is treated as two cases. If both signs are possible, the form is
// enclosed twice, once for each sign (enclose, on_box.h), so that no formula is used outside its range.
struct Side {
  enum { any, negative, other } of = any;
  bool open = false;  // both signs are possible
};
// The case of the calling thread. No other thread reads it, and evaluations of cases do not nest.
inline thread_local Side sign_of_product;

// Evaluates one case while it lives. Afterwards no sign is excluded again: a later product of the thread
// belongs to no case.
class OneSide {
 public:
  template <class Of>
  explicit OneSide(Of of) {
    sign_of_product = {of, false};
  }
  ~OneSide() { sign_of_product = {}; }
  OneSide(const OneSide&) = delete;
  OneSide& operator=(const OneSide&) = delete;
  // Returns whether a product of this case may have either sign.
  bool open() const { return sign_of_product.open; }
};

// s = x_i x_o + y_i y_o is exactly the library's sum of products (the square of its side is 1), within 16
// units of the products that are summed: none of their factors exceeds 2.
template <class B>
Interval<B> tangential_product(const Geometry<Interval<B>>& g) {
  using I = Interval<B>;
  const I s = g.wi.x * g.wo.x + g.wi.y * g.wo.y;
  if (s.poisoned()) return s;
  const I both = sine(g.wi) * sine(g.wo);
  const double slack = 16 * I::kUnit;
  I r = cut(I::of(s.lo - slack, s.hi + slack), -both.hi - slack, both.hi + slack);
  if (r.lo < 0 && r.hi >= 0) {
    sign_of_product.open = true;
    if (sign_of_product.of == Side::negative) r.hi = -I::kTiny;
    if (sign_of_product.of == Side::other) r.lo = 0;
  }
  return r;
}

// cos Lambda = a phi(s), phi(s) = e^(-s^2)/2 (1/sqrt(pi) - s erfcx(s)) for s = cos/a. phi decreases (its
// derivative is -erfc(s)/2 < 0). Up to s = 10 it is at least 0.0028 e^(-s^2)/2, of which the roundings
// change less than 1/100. Beyond, s stays 10: the result is at most cos e^(-100)/2 instead of 0.
template <class B>
Interval<B> cos_lambda_beckmann(const Roughness<Interval<B>>& alpha, const Vec3<Interval<B>>& w) {
  using I = Interval<B>;
  const I a = sqrt(square(alpha.alpha_x * w.x) + square(alpha.alpha_y * w.y) + I(1e-30));
  const I s = w.z / a;
  if (s.poisoned()) return s;
  // Returns e^(-s^2)/2 (1/sqrt(pi) - s erfcx(s)) at a point s <= 10, as bounds.
  const auto phi = [](double at) {
    const Bounds e = erfcx_at(at);
    // Ten roundings of s change s^2 <= 100 by that factor in the exponent.
    const Bounds power{exp_at(-at * at * (1 + 16 * I::kUnit)).lo, exp_at(-at * at * (1 - 16 * I::kUnit)).hi};
    const double root = 0.56418958354775628695, slack = 64 * I::kUnit;
    return Bounds{0.5 * power.lo * std::max(root - at * e.hi - slack, 0.0) * (1 - slack),
                  0.5 * power.hi * (root - at * e.lo + slack) * (1 + slack)};
  };
  const double beyond = 1e-44 * std::max(w.z.hi, 1.0);
  const double flushed = I::kSingle ? 8.9 : 10;  // below e^-80 the power may be 0
  const double low = s.hi >= flushed ? (s.hi >= 10 ? -beyond : 0) : a.lo * phi(s.hi).lo;
  const double high = s.lo >= 10 ? beyond : a.hi * phi(std::max(s.lo, 0.0)).hi + beyond;
  return I::widened(low, high, 4);
}

// Returns the bounds of the polynomial R of Student's masking over its whole domain: x and y in [-1, 1] and
// slightly beyond.
Bounds student_polynomial();

// The reflectance of a conductor lies in [0, 1], in exact arithmetic and as computed in either precision. s
// and p are quotients of sums of squares and therefore not below 0. The two sums of p differ by a sign
// between terms that are not negative. The result is cut at 1. Divisors are kept above the floor, or the
// quotient is not chosen. No term reaches 1e20 if n and k are below 1e4.
template <class B>
Interval<B> fresnel_conductor(const Interval<B>& n, const Interval<B>& k, const Interval<B>& c) {
  const Interval<B> op_by_op = brdf::fresnel_conductor<Interval<B>>(n, k, c);
  const auto within = [](const Interval<B>& x, double high) {
    return !x.poisoned() && x.lo >= 0 && x.hi <= high;
  };
  if (!within(n, 1e4) || !within(k, 1e4) || !within(c, 1)) return op_by_op;
  return op_by_op.poisoned() ? Interval<B>::of(0, 1) : cut(op_by_op, 0, 1);
}

}  // namespace brdf::prove

namespace brdf {

// The library's masking, with two additional facts: the squared sine of the stretched direction is at most
// 1, and the polynomial lies between its bounds.
template <class B>
class StudentMasking<prove::Interval<B>> {
  using I = prove::Interval<B>;

 public:
  explicit StudentMasking(const I& gamma) : gamma_(gamma) {}

  I length(const Roughness<I>& a, const Vec3<I>& w) const {
    const I tangent2 = square(a.alpha_x * w.x) + square(a.alpha_y * w.y);
    const I length2 = tangent2 + square(w.z), stretched = math::sqrt(length2);
    const I sine2 = prove::cut(tangent2 / length2, 0, 1 + 4 * I::kUnit);
    const prove::Bounds r = prove::student_polynomial();
    const I scale = square(gamma_ + I(2)) / ((gamma_ - I(1.5)) * ((gamma_ - I(0.5)) * (gamma_ + I(0.5))));
    return stretched * (math::pow(sine2, gamma_ - I(1)) * (scale * I::of(r.lo - 1e-5, r.hi + 1e-5))) + w.z;
  }

 private:
  I gamma_;
};

}  // namespace brdf
