// The factors D, V and F of microfacet forms, in numerically stable formulations.
//
// D and V are carried as fractions; a form therefore divides only once. V = G / (4 cos_i cos_o). All
// functions work in the local frame with the unnormalised half vector: computing through 1 - (n.h)^2 would
// cost 3.5e-8/alpha^2 in float.
#pragma once

#include "brdf/geometry.h"
#include "brdf/parameter.h"
#include "brdf/two_part.h"

namespace brdf {

template <class T>
struct Fraction {
  T num, den;
};

// A power of two that keeps the product of the denominators of D and V within the normal range of float
// when both directions graze (2.7e-32 instead of 1e-40). It does not change any bit of the result.
inline constexpr double kDenominatorScale = 268435456.0;  // 2^28

template <class A, class B>
auto quotient(const Fraction<A>& d, const Fraction<B>& v) {
  return (d.num * v.num) / (d.den * v.den);
}

// Returns (h_x/alpha_x)^2 + (h_y/alpha_y)^2.
template <class S, class G>
S scaled_tangent2(const Roughness<S>& a, const Geometry<G>& g) {
  return square(g.h.x) * square(S(1) / a.alpha_x) + square(g.h.y) * square(S(1) / a.alpha_y);
}

// GGX distribution. Trowbridge and Reitz 1975; Walter et al. 2007 eq. 33; anisotropic: Burley 2012.
template <class S, class G>
Fraction<S> d_ggx(const Roughness<S>& a, const Geometry<G>& g) {
  const S q = scaled_tangent2(a, g) + square(g.h.z);
  return {S(kDenominatorScale) * square(g.h2), S(kPi * kDenominatorScale) * a.alpha_x * a.alpha_y * (q * q)};
}

// Returns |(alpha_x x, alpha_y y, z)|.
template <class S, class G>
S stretched_length(const Roughness<S>& a, const Vec3<G>& w) {
  return math::sqrt(square(a.alpha_x * w.x) + square(a.alpha_y * w.y) + square(w.z));
}

// Height-correlated Smith masking and shadowing for GGX: Heitz 2014 eq. 99.
template <class S, class G>
Fraction<S> v_smith_ggx(const Roughness<S>& a, const Geometry<G>& g) {
  return {S(0.5), g.cos_o * stretched_length(a, g.wi) + g.cos_i * stretched_length(a, g.wo)};
}

// Returns 1/alpha^2 - square(1/alpha).
template <class T>
T inverse_square_rest(const T& alpha) {
  const T inverse = T(1) / alpha, rounded = square(inverse);
  return product_rest(inverse, inverse, rounded) - T(2) * rounded * product_rest(alpha, inverse, T(1));
}

// Returns the rounding error of scaled_tangent2, except that of its last three operations.
template <class S, class G>
auto scaled_tangent2_rest(const Roughness<S>& a, const Geometry<G>& g) {
  const auto term = [](const auto& h, const auto& h_rest, const auto& alpha) {
    return square(h) * inverse_square_rest(alpha) +
           (h + h) * h_rest * square(decltype(alpha + alpha)(1) / alpha);
  };
  return term(value_of(g.h.x), value_of(g.h_rest.x), value_of(a.alpha_x)) +
         term(value_of(g.h.y), value_of(g.h_rest.y), value_of(a.alpha_y));
}

// Returns h_z^2 in two parts.
template <class G>
auto normal_part2(const Geometry<G>& g) {
  const auto z = two_part(value_of(g.h.z), value_of(g.h_rest.z));
  return z * z;
}

// Returns exp(-n/d) for the scaled tangents n. `inverse` is 1/d rounded; d is given in two parts.
template <class S, class G, class T>
S slope_gaussian(const Roughness<S>& a, const Geometry<G>& g, const G& inverse, const TwoPart<T>& d) {
  const S tangent2 = scaled_tangent2(a, g);
  const S exponent = tangent2 * inverse;
  const T rest = quotient_rest(T(value_of(tangent2)), T(scaled_tangent2_rest(a, g)), d, T(value_of(inverse)),
                               T(value_of(exponent)));
  const S gaussian = math::exp(-exponent);
  return gaussian - gaussian * rest;
}

// Returns exp(-tan^2), the Gaussian of the half vector's slope scaled by the widths. `inverse` is 1/h_z^2.
// The result is 0 below e^-80 (float) or e^-690 (double).
template <class S, class G>
S slope_gaussian(const Roughness<S>& a, const Geometry<G>& g, const G& inverse) {
  return slope_gaussian(a, g, inverse, normal_part2(g));
}

// Beckmann distribution. Beckmann and Spizzichino 1963; Walter et al. 2007 eq. 25. (|h|^2/h_z^2)^2 is
// 1/cos^4, which would overflow as a power of a normalised cosine.
template <class S, class G>
Fraction<S> d_beckmann(const Roughness<S>& a, const Geometry<G>& g) {
  const G inverse = G(1) / square(g.h.z);
  return {slope_gaussian(a, g, inverse) * square(g.h2 * inverse), S(kPi) * a.alpha_x * a.alpha_y};
}

// Returns cos Lambda(w) of Smith's masking for Beckmann slopes, exact and without cancellation:
// e^(-s^2)/2 (a/sqrt(pi) - cos erfcx(s)) with a = |(alpha_x x, alpha_y y)| and s = cos/a.
// s is limited to 10, beyond which the result is 0.
template <class S, class G>
S cos_lambda_beckmann(const Roughness<S>& alpha, const Vec3<G>& w) {
  const S a = math::sqrt(square(alpha.alpha_x * w.x) + square(alpha.alpha_y * w.y) + S(1e-30));
  const S s = at_most(w.z / a, S(10));
  return S(0.5) * math::exp(-(s * s)) * (a * S(0.56418958354775628695) - w.z * math::erfcx(s));
}

// Height-correlated Smith masking and shadowing for Beckmann slopes: 1/(1 + Lambda_i + Lambda_o).
template <class S, class G>
Fraction<S> v_smith_beckmann(const Roughness<S>& a, const Geometry<G>& g) {
  return {S(0.25), g.cos_i * g.cos_o + g.cos_o * cos_lambda_beckmann(a, g.wi) +
                       g.cos_i * cos_lambda_beckmann(a, g.wo)};
}

// Masking of long V-shaped cavities (Torrance and Sparrow 1967): G = min(1, 2 cos_h cos_o/cos_d, 2 cos_h
// cos_i/cos_d).
// The fraction is scaled like D of GGX: with Beckmann's D the product would leave the range of float when
// both directions graze.
template <class G>
Fraction<G> v_cavities(const Geometry<G>& g) {
  const G scale(kDenominatorScale);
  return {scale * smaller(g.h2, G(4) * g.h.z * smaller(g.cos_i, g.cos_o)),
          scale * (G(4) * (g.cos_i * g.cos_o) * g.h2)};
}

// Schlick 1994 with k = (alpha + 1)^2/8 (Karis 2013, for analytic lights): G1 = cos/(cos (1 - k) + k). This
// is not Smith's masking of any distribution. alpha is the geometric mean of the widths.
template <class S>
S k_schlick_ggx(const Roughness<S>& a) {
  return S(0.125) * square(math::sqrt(a.alpha_x * a.alpha_y) + S(1));
}
template <class S, class G>
Fraction<S> v_schlick_ggx(const S& k, const Geometry<G>& g) {
  return {S(0.25), (g.cos_i * (S(1) - k) + k) * (g.cos_o * (S(1) - k) + k)};
}

// Schlick 1994: (1 - c)^5, the factor of (1 - f0) at the cosine c = wi.h. The clamp is needed because |h|/2
// rounds above 1 if wi = wo.
template <class G>
G schlick_weight(const G& c) {
  const G x = at_least(G(1) - c, G(0));
  return square(square(x)) * x;
}
template <class G>
G schlick(const Geometry<G>& g) {
  return schlick_weight(g.cos_d);
}

}  // namespace brdf
