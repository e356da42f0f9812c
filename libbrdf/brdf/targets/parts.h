// Common parts of targets: parameter sets, and a masking and a diffuse term that no form of the catalogue
// has.
#pragma once

#include "brdf/form.h"
#include "brdf/forms/cook_torrance.h"
#include "brdf/fresnel.h"
#include "brdf/microfacet.h"

namespace brdf {

// Smith's masking and shadowing as a product, G1(wi) G1(wo), for GGX: Walter et al. 2007 eq. 23 and 34. With
// G1 = 2 c/(c + l) and l the stretched length, V = G/(4 cos_i cos_o) is 1/((cos_i + l_i)(cos_o + l_o)).
template <class S, class G>
Fraction<S> v_separable_ggx(const Roughness<S>& a, const Geometry<G>& g) {
  return {S(1), (g.cos_i + stretched_length(a, g.wi)) * (g.cos_o + stretched_length(a, g.wo))};
}

// Burley 2012 (course notes, 5.3) as split by Cycles and Mitsuba, times pi and divided by the base colour:
// (1 - Fi/2)(1 - Fo/2) + R (Fi + Fo + Fi Fo (R - 1)), R = 2 roughness cos_d^2, roughness^4 = alpha_x alpha_y.
template <class S, class G>
S burley_diffuse(const Roughness<S>& a, const Geometry<G>& g) {
  const G fi = schlick_weight(g.cos_i), fo = schlick_weight(g.cos_o), both = fi * fo;
  const S r = math::sqrt(math::sqrt(a.alpha_x * a.alpha_y)) * (G(0.5) * g.h2);
  return (G(1) - G(0.5) * fi) * (G(1) - G(0.5) * fo) + r * (fi + fo + both * (r - S(1)));
}

// Returns ((eta - 1)/(eta + 1))^2.
template <class S>
S f0_of_index(const S& eta) {
  return square((eta - S(1)) / (eta + S(1)));
}

// The colour of models with one colour.
inline constexpr ParameterInfo kBaseColourInfo{
    "base_color", 0, 1, 0.5, 1, "", false, "the material's one colour", Role::diffuse};

// Weights of models with one colour. The part that this colour does not scale has the fixed weight 1.
template <class T>
struct BaseColour {
  T base_color, rest;
  static constexpr auto fields() {
    return std::array{Field{&BaseColour::base_color, kBaseColourInfo},
                      Field{&BaseColour::rest, ParameterInfo{"rest", 1, 1, 1, 1, "", false,
                                                             "weight of the uncoloured part: always 1"}}};
  }
  constexpr std::array<T, 2> linear() const { return {base_color, rest}; }
  static constexpr BaseColour from_linear(const std::array<T, 2>& w) { return {w[0], w[1]}; }
};

// The index of the dielectric part of principled models.
inline constexpr ParameterInfo kPrincipledIndexInfo{
    "eta", 1, 3, 1.5, 2, "", false, "relative index of refraction of the dielectric part", Role::index};

template <class T>
struct Principled {
  T alpha_x, alpha_y, metallic, eta;
  static constexpr auto fields() {
    return std::array{Field{&Principled::alpha_x, kAlongInfo}, Field{&Principled::alpha_y, kAcrossInfo},
                      Field{&Principled::metallic, kMetallicInfo},
                      Field{&Principled::eta, kPrincipledIndexInfo}};
  }
  Roughness<T> widths() const { return {alpha_x, alpha_y}; }
};

template <class T>
struct RoughConductor {
  T alpha_x, alpha_y, n, k;
  static constexpr auto fields() {
    return std::array{
        Field{&RoughConductor::alpha_x, kAlongInfo}, Field{&RoughConductor::alpha_y, kAcrossInfo},
        Field{&RoughConductor::n,
              ParameterInfo{"n", 0, 20, 1, 5, "", false, "index of refraction", Role::index}},
        Field{&RoughConductor::k,
              ParameterInfo{"k", 0, 20, 3, 10, "", false, "extinction coefficient", Role::extinction}}};
  }
  Roughness<T> widths() const { return {alpha_x, alpha_y}; }
};

}  // namespace brdf
