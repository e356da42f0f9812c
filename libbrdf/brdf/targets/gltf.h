#pragma once

#include "brdf/targets/parts.h"

namespace brdf {

inline constexpr ParameterInfo kSpecularShareInfo{
    "specular", 0, 1, 1, 1, "", false, "share of the dielectric part's lobe", Role::specular};

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

// glTF 2.0, metallic-roughness with KHR_materials_ior, _specular (the factor, no colour) and _anisotropy, as the
// specification's text has it: GGX with correlated masking; a metal is base + (1 - base)(1 - cos_d)^5 times that, a
// dielectric base/pi (1 - F) + F times that, F = specular (f0 + (1 - f0)(1 - cos_d)^5).
// Source: KhronosGroup/glTF, specification/2.0/Specification.adoc:2930-3248 (appendix B), extensions
// KHR_materials_specular and KHR_materials_ior (README.md, implementation). Programs that read glTF may compute more:
// three.js scales its lobe by a multiple-scattering term.
// Domain: alpha 1e-4..1, eta 1..3.
// Symmetry: anisotropic, reciprocal.
struct gltf_metallic_roughness : Takes<BaseColour, MetalOrDielectric> {
  static constexpr std::string_view name = "gltf_metallic_roughness";
  static constexpr std::string_view family = "gltf";
  static constexpr Kink kink = Kink::none;
  using Sampler = OfWidths<VisibleGgx>;
  static constexpr NoViolations violations{};

  template <class S, class G>
  static std::array<S, 2> lobes(const Shape<S>& shape, const Geometry<G>& g) {
    const Roughness<S> alpha = shape.widths();
    const S vd = quotient(d_ggx(alpha, g), v_smith_ggx(alpha, g));
    const S f0 = f0_of_index(shape.eta), dielectric = S(1) - shape.metallic;
    const G rise = schlick(g);
    const S f = shape.specular * (f0 + (S(1) - f0) * rise);
    return {dielectric * (S(1) - f) * S(1 / kPi) + shape.metallic * vd * (G(1) - rise),
            vd * (dielectric * f + shape.metallic * rise)};
  }
};

}  // namespace brdf
