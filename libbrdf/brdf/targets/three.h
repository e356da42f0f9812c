// The physical material of three.js as a target.
#pragma once

#include "brdf/targets/gltf.h"
#include "brdf/targets/three_table.h"

namespace brdf {

// The model is quadratic in its one colour; the colour is therefore a parameter of the shape. The model is
// linear in the weight of the whole.
template <class T>
struct WholeWeight {
  T whole;
  static constexpr auto fields() {
    return std::array{Field{&WholeWeight::whole,
                            ParameterInfo{"whole", 1, 1, 1, 1, "", false, "weight of the sum: always 1"}}};
  }
  constexpr std::array<T, 1> linear() const { return {whole}; }
  static constexpr WholeWeight from_linear(const std::array<T, 1>& w) { return {w[0]}; }
};

template <class T>
struct ThreePhysical {
  T alpha_x, alpha_y, metallic, eta, specular, base_color;
  static constexpr double kLeast = 0.045 * 0.045;
  static constexpr auto fields() {
    return std::array{
        Field{&ThreePhysical::alpha_x, ParameterInfo{"alpha_x", kLeast, 1, 0.3, 1, "", true,
                                                     "width along the tangent, the wider axis", Role::width}},
        Field{&ThreePhysical::alpha_y,
              ParameterInfo{"alpha_y", kLeast, 1, 0.3, 1, "", true, "width across the tangent: roughness^2",
                            Role::width_across}},
        Field{&ThreePhysical::metallic, kMetallicInfo},
        Field{&ThreePhysical::eta, kPrincipledIndexInfo},
        Field{&ThreePhysical::specular, kSpecularShareInfo},
        Field{&ThreePhysical::base_color, kBaseColourInfo}};
  }
  Roughness<T> widths() const { return {alpha_x, alpha_y}; }
};

// three.js 0.187, MeshPhysicalMaterial under a directional light: glTF's metallic-roughness with
// F = f0 + (f90 - f0) 2^((-5.55473 c - 6.98316) c). The lobe is multiplied by 1 + f0 (1/E - 1), with f0 the
// colour at normal incidence and E the tabulated albedo of a white lobe at the cosine of the viewing angle
// and the roughness (of the narrower axis).
// Source: three 0.187.0 (npm), src/renderers/shaders/ShaderChunk/lights_physical_pars_fragment.glsl.js
// (RE_Direct_Physical, BRDF_GGX), lights_physical_fragment.glsl.js, lights_fragment_begin.glsl.js,
// common.glsl.js (F_Schlick), DFGLUTData.js.
// Domain: alpha 0.002025..1, eta 1..3.
// Symmetry: anisotropic, not reciprocal.
// Known violations: reciprocity, energy.
struct three_physical : Takes<WholeWeight, ThreePhysical> {
  static constexpr std::string_view name = "three_physical";
  static constexpr std::string_view family = "three";
  static constexpr Kink kink = Kink::unplaced;  // at every row of the table
  using Sampler = OfWidths<VisibleGgx>;
  static constexpr std::array violations{
      Violation{"reciprocity", "the compensation depends on cos_o only", "metallic=1 base_color=1 alpha=1",
                89.5, 0.615864},
      Violation{"energy",
                "the compensation depends on the viewing direction, and grazing incidence receives too much",
                "metallic=1 base_color=1 alpha=1", 89.5, 2.0038}};

  template <class S, class G>
  static std::array<S, 1> lobes(const Shape<S>& shape, const Geometry<G>& g) {
    const S& base = shape.base_color;
    const S dielectric = S(1) - shape.metallic, plain = f0_of_index(shape.eta) * shape.specular;
    const S f0 = plain * dielectric + base * shape.metallic;
    const S f90 = shape.specular * dielectric + shape.metallic;
    const G c = at_most(g.cos_d, G(1));
    const G rise = math::exp(G(-0.69314718055994530942) * (G(5.55473) * c + G(6.98316)) * c);
    const S vd = quotient(d_ggx(shape.widths(), g), v_smith_ggx(shape.widths(), g));
    const S white = three_white_albedo(g.cos_o, math::sqrt(shape.alpha_y));
    const S compensation = S(1) + f0 * (S(1) / white - S(1));
    const S below = S(1) - (plain + (f90 - plain) * rise);
    return {base * dielectric * below * S(1 / kPi) + vd * (f0 + (f90 - f0) * rise) * compensation};
  }
};

}  // namespace brdf
