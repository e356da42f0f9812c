#pragma once

#include "brdf/targets/parts.h"

namespace brdf {

inline constexpr ParameterInfo kSpecularShareInfo{
    "specular", 0, 1, 1, 1, "", false, "share of the dielectric part's lobe", Role::specular};

inline constexpr ParameterInfo kSpecularColourInfo{
    "specular_color", 0, 10, 1, 1, "", false, "factor of the dielectric part's reflectance along the normal",
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

// The same whose dielectric part has a colour.
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

// Smith's V, held at 1 where the widths differ.
template <class S, class G>
Fraction<S> v_held_at_one(const Roughness<S>& a, const Geometry<G>& g) {
  const Fraction<S> v = v_smith_ggx(a, g);
  const S least = select(a.alpha_x < a.alpha_y, S(1), select(a.alpha_y < a.alpha_x, S(1), S(0)));
  return {v.num, at_least(v.den, least * v.num)};
}

// glTF 2.0, metallic-roughness with KHR_materials_ior, _specular and _anisotropy, per channel: GGX with
// correlated
// masking; a metal is base + (1 - base)(1 - cos_d)^5 times that, a dielectric base/pi (1 - F) + F times that,
// F = specular (f0 + (1 - f0)(1 - cos_d)^5), f0 = min(((eta - 1)/(eta + 1))^2 specular_color, 1).
// Sources, text: KhronosGroup/glTF@0554a7f3, specification/2.0/Specification.adoc, appendix B (D, V, F, the
// two mixes);
// extensions KHR_materials_ior and _specular (f0, f90; README.md, implementation); KHR_materials_anisotropy
// (alpha_x from
// the strength; V = clamp(V, 0, 1)). Program: Khronos's gltf-viewer 1.1.0 (npm), the same with two exceptions
// named below.
// Where they differ: of a coloured lobe the later text of KHR_materials_specular takes 1 - specular max(F_r,
// F_g, F_b) off
// the diffuse part, its first draft (05e0f7bb) mixes by colour, and the viewer takes 1 - specular F of each
// channel, as here:
// by the text a channel's diffuse part is darker by specular (max F - F) base/pi.
// Known: at grazing angles f jumps where the widths become equal: then KHR_materials_anisotropy is not
// written, and the
// isotropic V of appendix B has no limit. three.js holds nothing.
// Domain: alpha 1e-4..1, eta 1..3.
// Symmetry: anisotropic, reciprocal.
struct gltf_metallic_roughness : Takes<BaseColour, MetalOrTintedDielectric> {
  static constexpr std::string_view name = "gltf_metallic_roughness";
  static constexpr std::string_view family = "gltf";
  static constexpr Kink kink = Kink::unplaced;  // where V reaches 1
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
