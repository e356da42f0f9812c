// Facts that bounds of rounding cannot derive operation by operation: overloads that the unchanged forms
// select, each with its reason. Tests compare each with samples. u is the unit of one rounding,
// Rounded::kUnit.
#pragma once

#include "brdf/forms.h"
#include "prove/scalar/lemmas.h"
#include "prove/scalar/rounded.h"

namespace brdf::prove {

// Both choices by the sign of s are max(s, 0) over the larger cosine L. s = (P + Q)/2 is the sum of two
// products P and Q of sums of exact numbers. Its error is at most u |s| + 1.5 u (|P| + |Q|), and by Cauchy
// and Lagrange
//   |P| + |Q| <= sqrt((sin_i^2 - sin_o^2)^2 + 4 s^2) <= |cos_i^2 - cos_o^2| + d + 2 |s|,
// with d for vectors stored to two units. Divided by L this is 5 u of the quotient, plus at most
// 1.5 u (L + d/L).
template <class B>
Rounded<B> oren_nayar_azimuth(const Geometry<Rounded<B>>& g) {
  using R = Rounded<B>;
  const R l = larger(g.cos_i, g.cos_o);
  const double u = R::kUnit, d = 17 * u, highest = R::up(1.0001 / l.range.lo);
  return R::within({0, highest}, 5.02 * u,
                   R::up(1.51 * u * (l.range.hi + d / l.range.lo) + R::kTiny / l.range.lo));
}

// exp(-e). The rest removes at most kExponentUnits units of e again (lemmas.h).
template <class B>
Rounded<B> gaussian_of(const Rounded<B>& e) {
  using R = Rounded<B>;
  R exponent = e;
  exponent.relative.error = R::up(e.relative.error + 2 * kExponentUnits * R::kUnit);
  exponent.absolute = R::kNever;
  R gaussian = exp(-exponent.finished());
  gaussian.relative.error = R::up(gaussian.relative.error + 3 * R::kUnit);
  gaussian.peak.error = R::up(gaussian.peak.error + 3 * R::kUnit);
  gaussian.absolute = R::up(gaussian.absolute + 3 * R::kUnit);
  return gaussian.finished();
}
template <class B>
Rounded<B> slope_gaussian(const Roughness<Rounded<B>>& a, const Geometry<Rounded<B>>& g,
                          const Rounded<B>& inverse, const TwoPart<Rounded<B>>&) {
  return gaussian_of(scaled_tangent2(a, g) * inverse);
}

// N = r^2 e^-y, r = 1 + tan^2 <= 1 + y for widths up to 1. The error is N times the errors of r^2 and of
// the exponential, y e. Over y >= 0, (1 + y)^2 e^-y is at most 4/e = 1.4716, and y times that is at most
// 2.52. The peak of N, at the normal, is 1.
template <class B>
Fraction<Rounded<B>> d_beckmann(const Roughness<Rounded<B>>& a, const Geometry<Rounded<B>>& g) {
  using R = Rounded<B>;
  const R inverse = R(1) / square(g.h.z), r = square(g.h2 * inverse), y = scaled_tangent2(a, g) * inverse;
  const R area = R(kPi) * a.alpha_x * a.alpha_y;
  if (!(std::max(a.alpha_x.range.hi, a.alpha_y.range.hi) <= 1) || !r.relative.known() || !y.relative.known())
    return {R::unknown(), area};
  const double exponent = y.relative.error + 2 * kExponentUnits * R::kUnit;
  const double factor = R::kKernel + 5 * R::kUnit + r.relative.error;
  const double flushed = R::I::kSingle ? 1e-30 : 1e-290;  // (1 + 80)^2 e^-80
  return {R::beside({0, 1.4717}, R::up((2.53 * exponent + 1.4717 * factor) * (1 + 1e-4) + flushed), {1, 1}),
          area};
}

// cos Lambda = e^(-s^2)/2 (A - B), A = a/sqrt(pi), B = cos erfcx(s) <= A, s = min(cos/a, 10).
//
// The error of the difference is at most (e_A + e_B + u) A, that of the power (2 e_s + u) s^2. erfcx passes
// on at most the relative error of s. Relative to cos + cos Lambda = a (s + phi), with
// s + phi >= phi(0) = 1/(2 sqrt(pi)), the total is at most e^(-s^2) times these errors, and s^2 e^(-s^2) <=
// 1/e. Results flushed below e^-80 contribute 1e-35.
//
// The denominator
//   cos_i cos_o + cos_o (cos Lambda_i) + cos_i (cos Lambda_o)
// is at least half of
//   cos_o (cos_i + cos Lambda_i) + cos_i (cos_o + cos Lambda_o),
// so that its error is at most twice that error.
template <class B>
Fraction<Rounded<B>> v_smith_beckmann(const Roughness<Rounded<B>>& alpha, const Geometry<Rounded<B>>& g) {
  using R = Rounded<B>;
  const double u = R::kUnit;
  const auto beside = [&](const Vec3<R>& w) {
    const R a = sqrt(square(alpha.alpha_x * w.x) + square(alpha.alpha_y * w.y) + R(1e-30));
    const double e_a = a.relative.error + 2 * u, e_s = a.relative.error + u, e_b = e_s + 2 * R::kKernel + u;
    return (e_a + e_b + u) + (2 * e_s + u) / 2.718 + R::kKernel + 3 * u;
  };
  const double error = R::up(2 * std::max(beside(g.wi), beside(g.wo)) * (1 + 1e-4) + 3.01 * u);
  if (!(error < 0.1)) return {R(0.25), R::unknown()};
  // cos Lambda is at most a/(2 sqrt(pi)), and a is at most the larger width.
  const double width = std::max(alpha.alpha_x.range.hi, alpha.alpha_y.range.hi) * 0.29, i = g.cos_i.range.hi,
               o = g.cos_o.range.hi;
  return {
      R(0.25),
      R::within({g.cos_i.range.lo * g.cos_o.range.lo * (1 - 1e-12), R::up(i * o + (i + o) * width)}, error)};
}

// (n.h)^n = exp(-n/2 log1p(tan^2)). The rest changes the logarithm by at most kExponentUnits units
// (lemmas.h).
template <class B>
Rounded<B> half_cosine_power(const Rounded<B>& n, const Geometry<Rounded<B>>& g) {
  using R = Rounded<B>;
  R logarithm = log1p((square(g.h.x) + square(g.h.y)) * (R(1) / square(g.h.z)));
  logarithm.relative.error = R::up(logarithm.relative.error + 2 * kExponentUnits * R::kUnit);
  logarithm.absolute = R::kNever;
  return exp(n * (R(-0.5) * logarithm.finished()));
}

// At the edge of the mirror lobe the power with a small exponent is a step: one rounding changes the power
// by its whole height.
template <class B>
Rounded<B> mirror_cosine_power(const Rounded<B>&, const Geometry<Rounded<B>>&) {
  return Rounded<B>::unknown();
}

// (c sum - 1)/(c difference + 1) cancels, but its square is added to 1. This shows if the ranges of eta and
// c are split into parts. For an index of at least 1 there is no total reflection.
template <class B>
Rounded<B> fresnel_dielectric(const Rounded<B>& eta, const Rounded<B>& c) {
  using R = Rounded<B>;
  if (!(eta.range.lo >= 1 && eta.range.hi < 100) || !eta.exact() || !c.relative.known() || c.range.lo <= 0)
    return R::unknown();
  constexpr int kParts = 24;
  const auto part = [](Bounds range, int k) {
    const auto at = [&](int j) { return range.lo + (range.hi - range.lo) * (double(j) / kParts); };
    return Bounds{at(k), k + 1 == kParts ? range.hi : at(k + 1)};
  };
  double error = 0, low = 1, high = 0;
  for (int j = 0; j < kParts; ++j)
    for (int k = 0; k < kParts; ++k) {
      const Bounds e = part(eta.range, j), x = part(c.range, k);
      const double beyond_1 = std::max(e.lo, 1 + 2 * R::kUnit);  // an index of 1 reflects nothing, exactly
      if (beyond_1 > e.hi) continue;
      const R f = brdf::fresnel_dielectric<R, R>(R::of(beyond_1, e.hi), R::within(x, c.relative.error));
      error = std::max(error, f.relative.known() && f.relative.underflow == 0 ? f.relative.error : R::kNever);
      low = std::min(low, f.range.lo);
      high = std::max(high, f.range.hi);
    }
  if (eta.range.lo <= 1) low = 0;
  return error < 1 ? R::within({std::max(low, 0.0), high}, error) : R::unknown();
}

// The reflectance of a conductor cancels if the indices match. Its error is sampled instead.
template <class B>
Rounded<B> fresnel_conductor(const Rounded<B>&, const Rounded<B>&, const Rounded<B>&) {
  return Rounded<B>::unknown();
}

}  // namespace brdf::prove
