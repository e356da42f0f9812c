// The factors D, V, F of microfacet forms, in the numerically stable forms.
//
// D and V are carried as fractions, so that a form divides once. V = G / (4 cos_i cos_o). All work in the
// local frame with the unnormalised half vector: going through 1 - (n.h)^2 would cost 3.5e-8/alpha^2 in
// float.
#pragma once

#include "brdf/geometry.h"
#include "brdf/parameter.h"

namespace brdf {

template <class T>
struct Fraction {
  T num, den;
};

// A power of two that keeps the product of D's and V's denominators in float's normal range at double grazing
// (2.7e-32 instead of 1e-40), without touching a bit of the result.
inline constexpr double kDenominatorScale = 268435456.0;  // 2^28

template <class A, class B>
auto quotient(const Fraction<A>& d, const Fraction<B>& v) {
  return (d.num * v.num) / (d.den * v.den);
}

// (h_x/alpha_x)^2 + (h_y/alpha_y)^2
template <class S, class G>
S scaled_tangent2(const Roughness<S>& a, const Geometry<G>& g) {
  return square(g.h.x * (S(1) / a.alpha_x)) + square(g.h.y * (S(1) / a.alpha_y));
}

// Trowbridge and Reitz 1975; Walter et al. 2007 eq. 33; anisotropic: Burley 2012.
template <class S, class G>
Fraction<S> d_ggx(const Roughness<S>& a, const Geometry<G>& g) {
  const S q = scaled_tangent2(a, g) + square(g.h.z);
  return {S(kDenominatorScale) * square(g.h2), S(kPi * kDenominatorScale) * a.alpha_x * a.alpha_y * (q * q)};
}

// |(alpha_x x, alpha_y y, z)|
template <class S, class G>
S stretched_length(const Roughness<S>& a, const Vec3<G>& w) {
  return math::sqrt(square(a.alpha_x * w.x) + square(a.alpha_y * w.y) + square(w.z));
}

// Height-correlated Smith masking and shadowing for GGX: Heitz 2014 eq. 99.
template <class S, class G>
Fraction<S> v_smith_ggx(const Roughness<S>& a, const Geometry<G>& g) {
  return {S(0.5), g.cos_o * stretched_length(a, g.wi) + g.cos_i * stretched_length(a, g.wo)};
}

// Schlick 1994: (1 - wi.h)^5, the factor of (1 - f0). The clamp: |h|/2 rounds above 1 where wi = wo.
template <class G>
G schlick(const Geometry<G>& g) {
  const G x = at_least(G(1) - g.cos_d, G(0));
  return square(square(x)) * x;
}

}  // namespace brdf
