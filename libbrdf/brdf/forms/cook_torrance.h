// The Cook-Torrance form with several distributions, maskings and Fresnel terms.
#pragma once

#include "brdf/facets.h"
#include "brdf/form.h"
#include "brdf/forms/listing.h"
#include "brdf/fresnel.h"
#include "brdf/microfacet.h"
#include "brdf/samplers.h"

namespace brdf {

// Cook and Torrance 1982 with the distribution of Trowbridge and Reitz (GGX), height-correlated Smith masking
// (Heitz 2014) and Schlick's Fresnel: f = kd/pi + ks D G F/(4 cos_i cos_o), F = f0 + (1 - f0)(1 - wi.h)^5.
// The form is linear for given widths: the lobes 1/pi, V D, V D s have the weights kd, ks f0, ks (1 - f0).
// Domain: alpha 1e-4..1, f0 0..1.
// Symmetry: anisotropic, reciprocal.
// Known violations: only for kd + ks > 1. Single scattering loses up to 69 % (alpha 1, normal incidence).
struct cook_torrance : Takes<SchlickWeights, Roughness> {
  static constexpr std::string_view name = "cook_torrance";
  static constexpr std::string_view family = "cook_torrance";
  static constexpr Accuracy accuracy{.in_float = {3.2e-6, 3.2e-6, 2.7e-6},
                                     .in_double = {6.4e-15, 5.9e-15, 5.8e-15}};
  static constexpr Kink kink = Kink::none;
  using Facets = brdf::Facets<GgxSlopes, SmithGgx>;
  using Sampler = VisibleGgx;
  static constexpr NoViolations violations{};

  template <class S, class G>
  static std::array<S, 3> lobes(const Shape<S>& shape, const Geometry<G>& g) {
    const S vd = quotient(d_ggx(shape, g), v_smith_ggx(shape, g));
    return {S(1 / kPi), vd, vd * schlick(g)};
  }
};

// Cook-Torrance with Beckmann's distribution and its exact, height-correlated Smith masking (Walter et al.
// 2007 without their rational fit): f = kd/pi + ks D G F/(4 cos_i cos_o), Schlick's Fresnel.
// Domain: alpha 1e-4..1, f0 0..1.
// Symmetry: anisotropic, reciprocal.
// Known violations: only for kd + ks > 1. Single scattering loses up to 54 % (alpha 1, normal incidence).
struct cook_torrance_beckmann : Takes<SchlickWeights, Roughness> {
  static constexpr std::string_view name = "cook_torrance_beckmann";
  static constexpr std::string_view family = "cook_torrance";
  static constexpr Accuracy accuracy{.in_float = {4.3e-6, 6.2e-6, 1.5e-5},
                                     .in_double = {7.7e-15, 1.2e-14, 2.5e-14}};
  static constexpr Kink kink = Kink::none;
  using Facets = brdf::Facets<BeckmannSlopes, SmithBeckmann>;
  using Sampler = VisibleBeckmann;
  static constexpr NoViolations violations{};

  template <class S, class G>
  static std::array<S, 3> lobes(const Shape<S>& shape, const Geometry<G>& g) {
    const S vd = quotient(d_beckmann(shape, g), v_smith_beckmann(shape, g));
    return {S(1 / kPi), vd, vd * schlick(g)};
  }
};

template <class T>
struct RoughDielectric {
  T alpha_x, alpha_y, eta;
  static constexpr auto fields() {
    return std::array{
        Field{&RoughDielectric::alpha_x, kAlongInfo}, Field{&RoughDielectric::alpha_y, kAcrossInfo},
        Field{&RoughDielectric::eta,
              ParameterInfo{"eta", 1, 5, 1.5, 3, "", false, "relative index of refraction", Role::index}}};
  }
  Roughness<T> widths() const { return {alpha_x, alpha_y}; }
};

// Like cook_torrance, with the exact Fresnel reflectance of a dielectric instead of Schlick's approximation.
// Domain: alpha 1e-4..1, eta 1..5.
// Symmetry: anisotropic, reciprocal.
// Known violations: only for kd + ks > 1.
struct cook_torrance_dielectric : Takes<LobeWeights, RoughDielectric> {
  static constexpr std::string_view name = "cook_torrance_dielectric";
  static constexpr std::string_view family = "cook_torrance";
  static constexpr Accuracy accuracy{.in_float = {3.6e-6, 3.7e-6, 3.6e-6},
                                     .in_double = {6.2e-15, 7e-15, 6.7e-15}};
  static constexpr Kink kink = Kink::none;
  using Facets = brdf::Facets<GgxSlopes, SmithGgx>;
  using Sampler = OfWidths<VisibleGgx>;
  static constexpr NoViolations violations{};

  template <class S, class G>
  static std::array<S, 2> lobes(const Shape<S>& shape, const Geometry<G>& g) {
    const Roughness<S> alpha = shape.widths();
    const S vd = quotient(d_ggx(alpha, g), v_smith_ggx(alpha, g));
    return {S(1 / kPi), vd * fresnel_dielectric(shape.eta, g.cos_d)};
  }
};

template <class T>
struct RoughMetal {
  T alpha_x, alpha_y, n, k;
  static constexpr auto fields() {
    return std::array{Field{&RoughMetal::alpha_x, kAlongInfo}, Field{&RoughMetal::alpha_y, kAcrossInfo},
                      Field{&RoughMetal::n, ParameterInfo{"n", 0.02, 20, 1, 5, "", false,
                                                          "index of refraction", Role::index}},
                      Field{&RoughMetal::k, ParameterInfo{"k", 0.1, 20, 3, 10, "", false,
                                                          "extinction coefficient", Role::extinction}}};
  }
  Roughness<T> widths() const { return {alpha_x, alpha_y}; }
};

// Returns the Fresnel reflectance of facets with the n and k of the shape.
template <template <class> class Metal, class S, class G>
S fresnel_of(const Metal<S>& shape, const Geometry<G>& g) {
  return fresnel_conductor(shape.n, shape.k, S(at_most(g.cos_d, G(1))));
}

// Like cook_torrance, with the exact Fresnel reflectance of a conductor with index n + i k instead of
// Schlick's approximation. The colour of a metal follows from n and k, which need a shape of their own for
// each channel (fit: --per-channel --tie alpha; --start n=TABLE k=TABLE).
// Domain: alpha 1e-4..1, n 0.02..20, k 0.1..20. Without extinction and with n below 1 the reflectance has
// an edge at the angle of total reflection; there even the rounding of a direction has a large effect.
// Symmetry: anisotropic, reciprocal.
// Known violations: only for kd + ks > 1.
struct cook_torrance_conductor : Takes<LobeWeights, RoughMetal> {
  static constexpr std::string_view name = "cook_torrance_conductor";
  static constexpr std::string_view family = "cook_torrance";
  static constexpr Accuracy accuracy{.in_float = {4.2e-6, 3.7e-6, 3.6e-6},
                                     .in_double = {7.1e-15, 7e-15, 6.8e-15}};
  static constexpr Kink kink = Kink::none;
  using Facets = brdf::Facets<GgxSlopes, SmithGgx>;
  using Sampler = OfWidths<VisibleGgx>;
  static constexpr NoViolations violations{};

  template <class S, class G>
  static std::array<S, 2> lobes(const Shape<S>& shape, const Geometry<G>& g) {
    const Roughness<S> alpha = shape.widths();
    const S vd = quotient(d_ggx(alpha, g), v_smith_ggx(alpha, g));
    return {S(1 / kPi), vd * fresnel_of(shape, g)};
  }
};

// The model of the lookup-texture article: Beckmann's distribution, V-cavities, exact dielectric Fresnel
// (the constants of the article: eta 1.5, alpha 0.3). Its F D'/(pi cos_i cos_o) with
// D' = exp(-tan^2/m^2)/(4 m^2 cos^4) equals F D/(4 cos_i cos_o) with D normalised.
// Domain: alpha 1e-4..1, eta 1..5.
// Symmetry: anisotropic, reciprocal.
// Known violations: only for kd + ks > 1.
struct cook_torrance_vcavity : Takes<LobeWeights, RoughDielectric> {
  static constexpr std::string_view name = "cook_torrance_vcavity";
  static constexpr std::string_view family = "cook_torrance";
  static constexpr Accuracy accuracy{.in_float = {4.6e-6, 6e-6, 1.6e-5},
                                     .in_double = {8.2e-15, 1.1e-14, 2.4e-14}};
  static constexpr Kink kink = Kink::v_cavity;
  using Facets = brdf::Facets<BeckmannSlopes, VCavities>;
  using Sampler = OfWidths<GaussianSlopes>;
  static constexpr NoViolations violations{};

  template <class S, class G>
  static std::array<S, 2> lobes(const Shape<S>& shape, const Geometry<G>& g) {
    const S vd = quotient(d_beckmann(shape.widths(), g), v_cavities(g));
    return {S(1 / kPi), vd * fresnel_dielectric(shape.eta, g.cos_d)};
  }
};

// Cook and Torrance 1982 eq. 9 as widely copied, with pi instead of 4 in the denominator, a normalised D
// (Beckmann's), V-cavities and Schlick's Fresnel: f = kd/pi + ks D G F/(pi cos_i cos_o).
// Domain: alpha 1e-4..1, f0 0..1.
// Symmetry: anisotropic, reciprocal.
// Known violations: energy, by up to 4/pi (f0 1, alpha to 0, normal incidence).
struct cook_torrance_1982 : Takes<SchlickWeights, Roughness> {
  static constexpr std::string_view name = "cook_torrance_1982";
  static constexpr std::string_view family = "cook_torrance";
  static constexpr Accuracy accuracy{.in_float = {5.1e-6, 6.5e-6, 1.5e-5},
                                     .in_double = {8.3e-15, 1.3e-14, 2.7e-14}};
  static constexpr Kink kink = Kink::v_cavity;
  using Facets = brdf::Facets<BeckmannSlopes, VCavities>;
  using Sampler = GaussianSlopes;
  static constexpr std::array violations{
      Violation{"energy", "albedo up to 4/pi: the denominator has pi instead of 4",
                "kd=0 ks=1 f0=1 alpha_x=0.0001 alpha_y=0.0001", 0, 4 / kPi}};

  template <class S, class G>
  static std::array<S, 3> lobes(const Shape<S>& shape, const Geometry<G>& g) {
    const S vd = S(4 / kPi) * quotient(d_beckmann(shape, g), v_cavities(g));
    return {S(1 / kPi), vd, vd * schlick(g)};
  }
};

// The equation of the thesis with F at wi.h: GGX, G = product of cos/(cos (1 - k) + k) with
// k = (alpha + 1)^2/8, Schlick's Fresnel. k is computed with the geometric mean of the widths.
// Domain: alpha 1e-4..1, f0 0..1.
// Symmetry: anisotropic, reciprocal.
// Known violations: G is not Smith's (92 % too low at alpha 0.0036, cosine 0.01): the weak white furnace
// loses energy. Anisotropic lobes violate energy conservation.
struct cook_torrance_schlick_ggx : Takes<SchlickWeights, Roughness> {
  static constexpr std::string_view name = "cook_torrance_schlick_ggx";
  static constexpr std::string_view family = "cook_torrance";
  static constexpr Accuracy accuracy{.in_float = {3.6e-6, 3.3e-6, 2.8e-6},
                                     .in_double = {6.6e-15, 6.2e-15, 3.8e-15}};
  static constexpr Kink kink = Kink::none;
  using Facets = brdf::Facets<GgxSlopes, SchlickGgx>;
  using Sampler = VisibleGgx;
  static constexpr std::array violations{
      Violation{"energy",
                "anisotropic lobes: k is taken from the geometric mean of "
                "the widths, and masks too little along the wider",
                "kd=0 ks=1 f0=1 alpha_x=1 alpha_y=0.0001", 89.5, 3.27715},
      Violation{"white_furnace", "G is not Smith's: the relative error of the visible area is up to 288 %",
                "kd=0 ks=1 f0=1 alpha_x=1 alpha_y=0.0001", 89.9, 2.88}};

  template <class S, class G>
  static std::array<S, 3> lobes(const Shape<S>& shape, const Geometry<G>& g) {
    const S vd = quotient(d_ggx(shape, g), v_schlick_ggx(k_schlick_ggx(shape), g));
    return {S(1 / kPi), vd, vd * schlick(g)};
  }
};

// The form as printed in the thesis: cook_torrance_schlick_ggx with Schlick's Fresnel at n.wo instead of
// wi.h.
// Domain: alpha 1e-4..1, f0 0..1.
// Symmetry: anisotropic, not reciprocal.
// Known violations: reciprocity, in addition to the violations of cook_torrance_schlick_ggx.
struct cook_torrance_as_printed : Takes<SchlickWeights, Roughness> {
  static constexpr std::string_view name = "cook_torrance_as_printed";
  static constexpr std::string_view family = "cook_torrance";
  static constexpr Accuracy accuracy{.in_float = {4.2e-6, 3.5e-6, 3e-6},
                                     .in_double = {7.9e-15, 6.8e-15, 3.9e-15}};
  static constexpr Kink kink = Kink::none;
  using Facets = brdf::Facets<GgxSlopes, SchlickGgx>;
  using Sampler = VisibleGgx;
  static constexpr std::array violations{
      Violation{"reciprocity", "the Fresnel term depends on cos_o only", "kd=0 ks=1 f0=0 alpha_x=1 alpha_y=1",
                89.5, 1},
      Violation{"energy",
                "anisotropic lobes: k is taken from the geometric mean of "
                "the widths, and masks too little along the wider",
                "kd=0 ks=1 f0=1 alpha_x=1 alpha_y=0.0001", 89.5, 3.27715},
      Violation{"white_furnace", "G is not Smith's: the relative error of the visible area is up to 288 %",
                "kd=0 ks=1 f0=1 alpha_x=1 alpha_y=0.0001", 89.9, 2.88}};

  template <class S, class G>
  static std::array<S, 3> lobes(const Shape<S>& shape, const Geometry<G>& g) {
    const S vd = quotient(d_ggx(shape, g), v_schlick_ggx(k_schlick_ggx(shape), g));
    const G x = (square(g.wo.x) + square(g.wo.y)) / (G(1) + g.cos_o);  // 1 - cos_o
    return {S(1 / kPi), vd, vd * (square(square(x)) * x)};
  }
};

template <class T>
struct MetallicRoughness {
  T roughness, metallic;
  static constexpr auto fields() {
    return std::array{Field{&MetallicRoughness::roughness,
                            ParameterInfo{"roughness", 0.01, 1, 0.5, 1, "", true, "square root of alpha",
                                          Role::other, Map::roughness}},
                      Field{&MetallicRoughness::metallic, kMetallicInfo}};
  }
  Roughness<T> widths() const { return {square(roughness), square(roughness)}; }
};

// The listing of the thesis: f cos_i = (c/(c + 1))^(1/2.2) with
// c = (kD albedo/pi + D G F/(4 cos_i cos_o + 0.001)) cos_i, alpha = roughness^2, k = (roughness + 1)^2/8 in
// G, F at wi.h, and kD = (1 - F)(1 - metallic) of the red channel. The tone map is part of the function:
// the value is display-referred, not a reflectance.
// Domain: roughness 0.01..1.
// Symmetry: isotropic, not reciprocal.
// Known violations: reciprocity, energy. The constant 0.001 bends the lobe at cosines of 0.00025. No
// integration rule has information about this kink.
struct cook_torrance_as_coded : Takes<Albedo, MetallicRoughness> {
  static constexpr std::string_view name = "cook_torrance_as_coded";
  static constexpr std::string_view family = "cook_torrance";
  static constexpr Accuracy accuracy{.in_float = {5.9e-6, 6.5e-6, 6e-6},
                                     .in_double = {1.1e-14, 1.1e-14, 1.3e-14}};
  static constexpr Kink kink = Kink::unplaced;
  using Sampler = OneOf<Hemisphere, OfWidths<VisibleGgx>>;
  static constexpr std::array violations{
      Violation{"energy", "tone-mapped: albedo above 1, growing towards grazing incidence",
                "albedo=1 roughness=0.6 metallic=0", 89.5, 24.618},
      Violation{"reciprocity", "tone-mapped after the cosine", "albedo=1 roughness=0.31 metallic=0", 89.5,
                0.93339}};

  template <class S, class G>
  static S value_cos(const Weights<S>& w, const Weights<S>& first, const Shape<S>& shape,
                     const Geometry<G>& g) {
    const Fraction<S> d = d_ggx(shape.widths(), g);
    const Fraction<S> v = v_schlick_ggx(S(0.125) * square(shape.roughness + S(1)), g);
    const G cosines = g.cos_i * g.cos_o;
    // V = G/(4 cos_i cos_o). The listing adds 0.001 to that denominator.
    const S dg = d.num * v.num * (S(4) * cosines) / (d.den * v.den * (S(4) * cosines + S(0.001)));
    const S specular = dg * schlick_as_coded(w, shape.metallic, g);
    const S c =
        (diffuse_share_as_coded(first, shape.metallic, g) * w.albedo * S(1 / kPi) + specular) * g.cos_i;
    return math::pow(c / (c + S(1)), S(1 / 2.2));
  }
};

}  // namespace brdf
