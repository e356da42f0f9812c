// The metallic-roughness model of glTF 2.0 as a target.
#pragma once

#include "brdf/targets/parts.h"

namespace brdf {

inline constexpr ParameterInfo kSpecularShareInfo{
    "specular", 0, 1, 1, 1, "", false, "share of the dielectric lobe", Role::specular};

inline constexpr ParameterInfo kSpecularColourInfo{
    "specular_color", 0, 10, 1, 1, "", false, "factor of the dielectric reflectance at normal incidence",
    Role::tint};

template <class T>
struct MetalOrDielectric {
  T alpha_x, alpha_y, metallic, eta, specular;
  static constexpr auto fields() {
    return std::array{Field{&MetalOrDielectric::alpha_x, kAlongInfo},
                      Field{&MetalOrDielectric::alpha_y, kAcrossInfo},
                      Field{&MetalOrDielectric::metallic, kMetallicInfo},
                      Field{&MetalOrDielectric::eta, kPrincipledIndexInfo},
                      Field{&MetalOrDielectric::specular, kSpecularShareInfo}};
  }
  Roughness<T> widths() const { return {alpha_x, alpha_y}; }
};

// Has the same parameters, with a colour for the dielectric part.
template <class T>
struct MetalOrTintedDielectric {
  T alpha_x, alpha_y, metallic, eta, specular, specular_color;
  static constexpr auto fields() {
    return std::array{Field{&MetalOrTintedDielectric::alpha_x, kAlongInfo},
                      Field{&MetalOrTintedDielectric::alpha_y, kAcrossInfo},
                      Field{&MetalOrTintedDielectric::metallic, kMetallicInfo},
                      Field{&MetalOrTintedDielectric::eta, kPrincipledIndexInfo},
                      Field{&MetalOrTintedDielectric::specular, kSpecularShareInfo},
                      Field{&MetalOrTintedDielectric::specular_color, kSpecularColourInfo}};
  }
  Roughness<T> widths() const { return {alpha_x, alpha_y}; }
};

// Smith's V, limited to 1 if the widths differ.
template <class S, class G>
Fraction<S> v_held_at_one(const Roughness<S>& a, const Geometry<G>& g) {
  const Fraction<S> v = v_smith_ggx(a, g);
  const S least = select(a.alpha_x < a.alpha_y, S(1), select(a.alpha_y < a.alpha_x, S(1), S(0)));
  return {v.num, at_least(v.den, least * v.num)};
}

// glTF 2.0, metallic-roughness with KHR_materials_ior, _specular and _anisotropy, per channel. The lobe is
// GGX with correlated masking. A metal is base + (1 - base)(1 - cos_d)^5 times the lobe. A dielectric is
// base/pi (1 - F) + F times the lobe, with F = specular (f0 + (1 - f0)(1 - cos_d)^5) and
// f0 = min(((eta - 1)/(eta + 1))^2 specular_color, 1).
// Sources, text: KhronosGroup/glTF@0554a7f3, specification/2.0/Specification.adoc, appendix B (D, V, F, the
// two mixes); extensions KHR_materials_ior and _specular (f0, f90; README.md, implementation);
// KHR_materials_anisotropy (alpha_x from the strength; V = clamp(V, 0, 1)). Program: Khronos's gltf-viewer
// 1.1.0 (npm), which is the same with the two exceptions below.
// Differences: for a coloured lobe the later text of KHR_materials_specular reduces the diffuse part by the
// factor 1 - specular max(F_r, F_g, F_b). Its first draft (05e0f7bb) mixes by colour. The viewer uses
// 1 - specular F of each channel, and so does this form. According to the text the diffuse part of a
// channel is darker by specular (max F - F) base/pi.
// Known: at grazing angles f is discontinuous at equal widths. KHR_materials_anisotropy is then not
// written, and the isotropic V of appendix B is not limited. three.js never limits V.
// Domain: alpha 1e-4..1, eta 1..3.
// Symmetry: anisotropic, reciprocal.
struct gltf_metallic_roughness : Takes<BaseColour, MetalOrTintedDielectric> {
  static constexpr std::string_view name = "gltf_metallic_roughness";
  static constexpr std::string_view family = "gltf";
  static constexpr Kink kink = Kink::unplaced;  // at the edge of V = 1
  using Sampler = OfWidths<VisibleGgx>;
  static constexpr NoViolations violations{};

  template <class S, class G>
  static std::array<S, 2> lobes(const Shape<S>& shape, const Geometry<G>& g) {
    const Roughness<S> alpha = shape.widths();
    const S vd = quotient(d_ggx(alpha, g), v_held_at_one(alpha, g));
    const S f0 = at_most(f0_of_index(shape.eta) * shape.specular_color, S(1));
    const S dielectric = S(1) - shape.metallic;
    const G rise = schlick(g);
    const S f = shape.specular * (f0 + (S(1) - f0) * rise);
    return {dielectric * (S(1) - f) * S(1 / kPi) + shape.metallic * vd * (G(1) - rise),
            vd * (dielectric * f + shape.metallic * rise)};
  }
};

}  // namespace brdf
