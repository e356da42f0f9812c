// The surface nodes of MaterialX 1.39.6 as targets. Coat, sheen, transmission, emission and thin films are
// off.
//
// Each node mixes a metal and a dielectric by its metalness, and its dielectric lobe lies over a diffuse
// part: f = lobe + (1 - weight albedo(cos_o)) base. The albedo is that of the lobe in the direction of the
// viewer. The nodes are therefore not reciprocal. All lobes are those of materialx_lobe.
// Source: AcademySoftwareFoundation/MaterialX 4177b2cb (1.39.6), libraries/bxdf (the graphs of the nodes) and
// libraries/pbrlib/genglsl (mx_generalized_schlick_bsdf.glsl, mx_dielectric_bsdf.glsl,
// mx_conductor_bsdf.glsl, mx_oren_nayar_diffuse_bsdf.glsl, mx_burley_diffuse_bsdf.glsl,
// mx_artistic_ior.glsl).
#pragma once

#include "brdf/forms/oren_nayar.h"
#include "brdf/targets/gltf.h"
#include "brdf/targets/materialx.h"
#include "brdf/targets/three.h"

namespace brdf {

template <class T>
struct MetalOverBase {
  T alpha_x, alpha_y, metallic, eta, specular, base_color;
  static constexpr auto fields() {
    return std::array{Field{&MetalOverBase::alpha_x, kAlongInfo},
                      Field{&MetalOverBase::alpha_y, kAcrossInfo},
                      Field{&MetalOverBase::metallic, kMetallicInfo},
                      Field{&MetalOverBase::eta, kPrincipledIndexInfo},
                      Field{&MetalOverBase::specular, kSpecularShareInfo},
                      Field{&MetalOverBase::base_color, kBaseColourInfo}};
  }
  Roughness<T> widths() const { return {alpha_x, alpha_y}; }
};

// The compensation depends on the viewing direction only. White metals show the largest violations.
constexpr std::array<Violation, 2> of_white_metal(double reciprocity, double albedo) {
  constexpr std::string_view kWhiteMetal = "metallic=1 base_color=1 alpha=1";
  return {
      Violation{"reciprocity", "the compensation depends on cos_o only", kWhiteMetal, 89.5, reciprocity},
      Violation{"energy", "the compensation depends on the viewing direction", kWhiteMetal, 89.5, albedo}};
}
inline constexpr std::array kSchlickMetal = of_white_metal(0.668073, 2.12173);
inline constexpr std::array kConductorMetal = of_white_metal(0.666108, 2.09376);

// Returns metallic metal + (1 - metallic) dielectric.
template <class S>
S mixed(const S& metallic, const S& metal, const S& dielectric) {
  return metallic * metal + (S(1) - metallic) * dielectric;
}

// Returns the compensated lobe of Schlick's Fresnel term, from f0 along the normal to f90.
template <class S, class G>
S schlick_lobe(const MaterialxLobe<S>& lobe, const S& f0, const S& f90, const Geometry<G>& g) {
  return lobe.value * (f0 + (f90 - f0) * schlick(g)) * lobe.compensation(f0, f90);
}

// Returns the compensated lobe of a dielectric. The reflectance along the normal, root^2, gives the index.
template <class S, class G>
S dielectric_lobe(const MaterialxLobe<S>& lobe, const S& root, const Geometry<G>& g) {
  const S index = (S(1) + root) / (S(1) - root);
  return lobe.value * fresnel_dielectric(index, at_most(g.cos_d, G(1))) *
         lobe.compensation(square(root), S(1));
}

// Returns the compensated lobe of a conductor by its reflectance and its edge tint (Gulbrandsen 2014), which
// determine n and k.
template <class S, class G>
S artistic_lobe(const MaterialxLobe<S>& lobe, const S& reflectance, const S& edge, const Geometry<G>& g) {
  const S tiny(1e-30);
  const S r = at_most(at_least(reflectance, tiny), S(0.99));
  const S root = math::sqrt(r);
  const S n = edge * ((S(1) - r) / (S(1) + r)) + (S(1) - edge) * ((S(1) + root) / (S(1) - root));
  const S k2 = (square(n + S(1)) * r - square(n - S(1))) / (S(1) - r);
  const S f = fresnel_conductor(n, math::sqrt(at_least(k2, tiny)), S(at_most(g.cos_d, G(1))));
  return lobe.value * f * lobe.compensation(r, S(1));
}

// gltf_pbr: a metal of the base colour, and a dielectric of specular (f0 .. 1) with f0 of the index.
// Domain: alpha 1e-4..1, eta 1..3.
// Symmetry: anisotropic, not reciprocal.
// Known violations: reciprocity, energy.
struct materialx_gltf_pbr : Takes<WholeWeight, MetalOverBase> {
  static constexpr std::string_view name = "materialx_gltf_pbr";
  static constexpr std::string_view family = "materialx";
  static constexpr Kink kink = Kink::none;
  using Sampler = OfWidths<VisibleGgx>;
  static constexpr std::array violations = kSchlickMetal;

  template <class S, class G>
  static std::array<S, 1> lobes(const Shape<S>& shape, const Geometry<G>& g) {
    const MaterialxLobe<S> lobe = materialx_lobe(shape.widths(), g);
    const S f0 = f0_of_index(shape.eta) * shape.specular;
    const S base = shape.base_color * S(1 / kPi) * (S(1) - lobe.albedo(f0, shape.specular));
    return {mixed(shape.metallic, schlick_lobe(lobe, shape.base_color, S(1), g),
                  schlick_lobe(lobe, f0, shape.specular, g) + base)};
  }
};

template <class T>
struct OpenPbr {
  T alpha_x, alpha_y, metallic, eta, specular, base_color, diffuse_roughness;
  static constexpr auto fields() {
    return std::array{
        Field{&OpenPbr::alpha_x, kAlongInfo},
        Field{&OpenPbr::alpha_y, kAcrossInfo},
        Field{&OpenPbr::metallic, kMetallicInfo},
        Field{&OpenPbr::eta, kPrincipledIndexInfo},
        Field{&OpenPbr::specular, kSpecularShareInfo},
        Field{&OpenPbr::base_color, kBaseColourInfo},
        Field{&OpenPbr::diffuse_roughness,
              ParameterInfo{"diffuse_roughness", 0, 1, 0, 1, "", false, "roughness of the diffuse part"}}};
  }
  Roughness<T> widths() const { return {alpha_x, alpha_y}; }
};

// open_pbr_surface: a metal of the base colour, weighted by specular, and a dielectric over EON
// (oren_nayar_energy). `specular` scales the reflectance along the normal of the dielectric, up to 0.99999,
// and so changes its index.
// Domain: alpha 1e-4..1, eta 1..3, diffuse_roughness 0..1.
// Symmetry: anisotropic, not reciprocal.
// Known violations: reciprocity, energy.
struct open_pbr_surface : Takes<WholeWeight, OpenPbr> {
  static constexpr std::string_view name = "open_pbr_surface";
  static constexpr std::string_view family = "materialx";
  static constexpr Kink kink = Kink::azimuth;
  using Sampler = OfWidths<VisibleGgx>;
  static constexpr std::array violations = kSchlickMetal;

  template <class S, class G>
  static std::array<S, 1> lobes(const Shape<S>& shape, const Geometry<G>& g) {
    const MaterialxLobe<S> lobe = materialx_lobe(shape.widths(), g);
    const S root = math::sqrt(at_least(shape.specular, S(1e-30))) * (shape.eta - S(1)) / (shape.eta + S(1));
    const S base =
        oren_nayar_energy::value(Reflectivity<S>{shape.base_color}, Reflectivity<S>{shape.base_color},
                                 UnitRoughness<S>{shape.diffuse_roughness}, g);
    return {mixed(shape.metallic, shape.specular * schlick_lobe(lobe, shape.base_color, S(1), g),
                  dielectric_lobe(lobe, root, g) + (S(1) - lobe.albedo(square(root), S(1))) * base)};
  }
};

template <class T>
struct StandardSurface {
  T alpha_x, alpha_y, metallic, eta, specular, base_color, sigma;
  static constexpr auto fields() {
    return std::array{Field{&StandardSurface::alpha_x, kAlongInfo},
                      Field{&StandardSurface::alpha_y, kAcrossInfo},
                      Field{&StandardSurface::metallic, kMetallicInfo},
                      Field{&StandardSurface::eta, kPrincipledIndexInfo},
                      Field{&StandardSurface::specular, kSpecularShareInfo},
                      Field{&StandardSurface::base_color, kBaseColourInfo},
                      Field{&StandardSurface::sigma, kDiffuseSlopeInfo}};
  }
  Roughness<T> widths() const { return {alpha_x, alpha_y}; }
};

// standard_surface: a conductor whose reflectance is the base colour and whose edge tint is specular, and a
// dielectric, weighted by specular, over the qualitative form of Oren and Nayar.
// Domain: alpha 1e-4..1, eta 1..3, sigma 0..1.
// Symmetry: anisotropic, not reciprocal.
// Known violations: reciprocity, energy.
struct standard_surface : Takes<WholeWeight, StandardSurface> {
  static constexpr std::string_view name = "standard_surface";
  static constexpr std::string_view family = "materialx";
  static constexpr Kink kink = Kink::azimuth;
  using Sampler = OfWidths<VisibleGgx>;
  static constexpr std::array violations = kConductorMetal;

  template <class S, class G>
  static std::array<S, 1> lobes(const Shape<S>& shape, const Geometry<G>& g) {
    const MaterialxLobe<S> lobe = materialx_lobe(shape.widths(), g);
    const S root = (shape.eta - S(1)) / (shape.eta + S(1));
    const S base = shape.base_color * oren_nayar::lobes(SlopeDeviation<S>{shape.sigma}, g)[0];
    const S left = S(1) - shape.specular * lobe.albedo(square(root), S(1));
    return {mixed(shape.metallic, artistic_lobe(lobe, shape.base_color, shape.specular, g),
                  shape.specular * dielectric_lobe(lobe, root, g) + left * base)};
  }
};

template <class T>
struct UsdPreview {
  T alpha, metallic, eta, base_color;
  static constexpr auto fields() {
    return std::array{
        Field{&UsdPreview::alpha,
              ParameterInfo{"alpha", 1e-4, 1, 0.3, 1, "", true, "width: roughness^2", Role::width}},
        Field{&UsdPreview::metallic, kMetallicInfo}, Field{&UsdPreview::eta, kPrincipledIndexInfo},
        Field{&UsdPreview::base_color, kBaseColourInfo}};
  }
  Roughness<T> widths() const { return {alpha, alpha}; }
};

// UsdPreviewSurface, as MaterialX renders it: a conductor whose reflectance and edge tint are the colour, and
// a dielectric over (1 - metallic) Lambert. Between metal and dielectric the dielectric lobe takes the colour
// s = 1 + metallic (colour - 1): it rises from s (R + metallic (1 - R)) to s, with R of the index.
// Not covered: a coloured material between metal and dielectric, whose base is darkened by the mean over the
// channels.
// Domain: alpha 1e-4..1, eta 1..3.
// Symmetry: isotropic, not reciprocal.
// Known violations: reciprocity, energy.
struct usd_preview_surface : Takes<WholeWeight, UsdPreview> {
  static constexpr std::string_view name = "usd_preview_surface";
  static constexpr std::string_view family = "materialx";
  static constexpr Kink kink = Kink::none;
  using Sampler = OfWidths<VisibleGgx>;
  static constexpr std::array violations = kConductorMetal;

  template <class S, class G>
  static std::array<S, 1> lobes(const Shape<S>& shape, const Geometry<G>& g) {
    const MaterialxLobe<S> lobe = materialx_lobe(shape.widths(), g);
    const S& colour = shape.base_color;
    const S dielectric = S(1) - shape.metallic;
    const S f90 = dielectric + shape.metallic * colour;
    const S f0 = f90 * (dielectric * f0_of_index(shape.eta) + shape.metallic);
    const S base = (S(1) - lobe.albedo(f0, f90)) * dielectric * colour * S(1 / kPi);
    return {
        mixed(shape.metallic, artistic_lobe(lobe, colour, colour, g), schlick_lobe(lobe, f0, f90, g) + base)};
  }
};

template <class T>
struct DisneyPrincipled {
  T alpha_x, alpha_y, metallic, f0, base_color;
  static constexpr auto fields() {
    return std::array{
        Field{&DisneyPrincipled::alpha_x, kAlongInfo}, Field{&DisneyPrincipled::alpha_y, kAcrossInfo},
        Field{&DisneyPrincipled::metallic, kMetallicInfo},
        Field{&DisneyPrincipled::f0,
              ParameterInfo{"f0", 0, 0.08, 0.04, 0.08, "", false,
                            "reflectance of the dielectric facets at every angle: 0.08 specular", Role::f0}},
        Field{&DisneyPrincipled::base_color, kBaseColourInfo}};
  }
  Roughness<T> widths() const { return {alpha_x, alpha_y}; }
};

// disney_principled of MaterialX: a metal of the base colour, and a dielectric of constant reflectance f0
// (there is no Fresnel rise) over (1 - metallic) of Burley's diffuse term.
// Domain: alpha 1e-4..1, f0 0..0.08.
// Symmetry: anisotropic, not reciprocal.
// Known violations: reciprocity, energy.
struct disney_principled : Takes<WholeWeight, DisneyPrincipled> {
  static constexpr std::string_view name = "disney_principled";
  static constexpr std::string_view family = "materialx";
  static constexpr Kink kink = Kink::none;
  using Sampler = OfWidths<VisibleGgx>;
  static constexpr std::array violations = kSchlickMetal;

  template <class S, class G>
  static std::array<S, 1> lobes(const Shape<S>& shape, const Geometry<G>& g) {
    const Roughness<S> widths = shape.widths();
    const MaterialxLobe<S> lobe = materialx_lobe(widths, g);
    const S base = (S(1) - shape.f0) * (S(1) - shape.metallic) * shape.base_color *
                   burley_diffuse(widths, g) * S(1 / kPi);
    return {mixed(shape.metallic, schlick_lobe(lobe, shape.base_color, S(1), g),
                  shape.f0 * lobe.value * lobe.compensation(S(1), S(1)) + base)};
  }
};

}  // namespace brdf
