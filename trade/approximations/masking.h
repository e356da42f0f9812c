// Masking and shadowing terms, exact and approximate. Functors over widths and geometry return V = G/(4
// cos_i cos_o) as a fraction, as used by the forms.
#pragma once

#include "brdf/microfacet.h"
#include "trade/measure/rows.h"

namespace brdf::trade {

template <class T>
Geometry<T> geometry_of(const DirectionRow<T>& x) {
  return geometry(x.wi, x.wo);
}

inline constexpr auto smith_correlated = []<class S, class G>(const Roughness<S>& a,
                                                              const Geometry<G>& g) -> Fraction<S> {
  return v_smith_ggx(a, g);
};
// Smith's G1 of both directions, multiplied as if they were independent (Walter et al. 2007).
inline constexpr auto smith_separable = []<class S, class G>(const Roughness<S>& a,
                                                             const Geometry<G>& g) -> Fraction<S> {
  return {S(1), (g.cos_i + stretched_length(a, g.wi)) * (g.cos_o + stretched_length(a, g.wo))};
};
// Schlick's rational G1 with k = alpha/2 (Karis 2013, for image-based light).
inline constexpr auto schlick_ggx_half = []<class S, class G>(const Roughness<S>& a,
                                                              const Geometry<G>& g) -> Fraction<S> {
  return v_schlick_ggx(S(0.5) * a.alpha_x, g);
};
// Returns the same with k = (roughness + 1)^2/8, alpha = roughness^2 (Karis 2013, for analytic lights; the
// thesis's listing).
inline constexpr auto schlick_ggx_analytic = []<class S, class G>(const Roughness<S>& a,
                                                                  const Geometry<G>& g) -> Fraction<S> {
  return v_schlick_ggx(S(0.125) * square(math::sqrt(a.alpha_x) + S(1)), g);
};
// Returns the same with alpha instead of roughness (the thesis's equation).
inline constexpr auto schlick_ggx_printed = []<class S, class G>(const Roughness<S>& a,
                                                                 const Geometry<G>& g) -> Fraction<S> {
  return v_schlick_ggx(S(0.125) * square(a.alpha_x + S(1)), g);
};
// Hammon 2017: the correlated denominator, linear in the cosines: lerp(2 ci co, ci + co, alpha).
inline constexpr auto hammon_correlated = []<class S, class G>(const Roughness<S>& a,
                                                               const Geometry<G>& g) -> Fraction<S> {
  const G product = G(2) * g.cos_i * g.cos_o;
  return {S(0.5), product + a.alpha_x * (g.cos_i + g.cos_o - product)};
};
inline constexpr auto v_shaped_cavities =
    []<class S, class G>(const Roughness<S>&, const Geometry<G>& g) -> Fraction<G> { return v_cavities(g); };
// G = 1 (the lookup-texture article calls G meaningless).
inline constexpr auto masking_dropped = []<class S, class G>(const Roughness<S>&,
                                                             const Geometry<G>& g) -> Fraction<G> {
  return {G(0.25), g.cos_i * g.cos_o};
};

inline constexpr auto smith_beckmann = []<class S, class G>(const Roughness<S>& a,
                                                            const Geometry<G>& g) -> Fraction<S> {
  return v_smith_beckmann(a, g);
};

// Walter et al. 2007: G1 = (3.535 c + 2.181 c^2)/(1 + 2.276 c + 2.577 c^2) for c = 1/(alpha tan) < 1.6,
// otherwise 1.
template <class T>
T rational_g1(const T& c) {
  const T fit = (T(3.535) * c + T(2.181) * c * c) / (T(1) + T(2.276) * c + T(2.577) * c * c);
  return select(c < T(1.6), fit, T(1));
}
// Returns 1/(alpha tan(theta)) of a direction.
template <class T>
T inverse_scaled_tangent(const Roughness<T>& a, const Vec3<T>& w) {
  return w.z / (a.alpha_x * math::sqrt(square(w.x) + square(w.y) + T(1e-30)));
}
inline constexpr auto rational_beckmann = []<class T>(const Roughness<T>& a,
                                                      const Geometry<T>& g) -> Fraction<T> {
  const T g_i = rational_g1(inverse_scaled_tangent(a, g.wi)),
          g_o = rational_g1(inverse_scaled_tangent(a, g.wo));
  const T both = g_i * g_o;  // 1/(1 + L_i + L_o) with L = 1/G1 - 1
  return {T(0.25) * both, g.cos_i * g.cos_o * (g_i + g_o - both)};
};

// G1 of one direction.
inline constexpr auto g1_smith_ggx = []<class T>(const CosineRow<T>& x) -> T {
  const T sin2 = (T(1) - x.cosine) * (T(1) + x.cosine);
  return T(2) * x.cosine / (x.cosine + math::sqrt(square(x.width) * sin2 + square(x.cosine)));
};
template <class T>
T g1_schlick(const T& k, const T& c) {
  return c / (c * (T(1) - k) + k);
}
inline constexpr auto g1_schlick_half = []<class T>(const CosineRow<T>& x) -> T {
  return g1_schlick(T(0.5) * x.width, x.cosine);
};
inline constexpr auto g1_schlick_analytic = []<class T>(const CosineRow<T>& x) -> T {
  return g1_schlick(T(0.125) * square(math::sqrt(x.width) + T(1)), x.cosine);
};
// The thesis's equation, with alpha instead of the roughness of its listing.
inline constexpr auto g1_schlick_printed = []<class T>(const CosineRow<T>& x) -> T {
  return g1_schlick(T(0.125) * square(x.width + T(1)), x.cosine);
};
inline constexpr auto g1_smith_beckmann = []<class T>(const CosineRow<T>& x) -> T {
  const T sine = math::sqrt((T(1) - x.cosine) * (T(1) + x.cosine));
  return x.cosine /
         (x.cosine + cos_lambda_beckmann(Roughness<T>{x.width, x.width}, Vec3<T>{sine, T(0), x.cosine}));
};
inline constexpr auto g1_rational_beckmann = []<class T>(const CosineRow<T>& x) -> T {
  const T sine = math::sqrt((T(1) - x.cosine) * (T(1) + x.cosine));
  return rational_g1(inverse_scaled_tangent(Roughness<T>{x.width, x.width}, Vec3<T>{sine, T(0), x.cosine}));
};

// V as a kernel.
template <class V>
struct visibility {
  V v;
  template <class T>
  T operator()(const DirectionRow<T>& x) const {
    const Fraction<T> f = v(Roughness<T>{x.width, x.width}, geometry_of(x));
    return f.num / f.den;
  }
};

}  // namespace brdf::trade
