// Models of Blender (Cycles) as targets.
#pragma once

#include "brdf/targets/parts.h"

namespace brdf {

// Blender 3.4, Cycles: a Diffuse BSDF (roughness 0) and a Glossy or Anisotropic BSDF with distribution GGX,
// combined by an Add Shader: f = kd/pi + ks D G1(wi) G1(wo)/(4 cos_i cos_o), without Fresnel.
// Source: Blender v3.4.0, intern/cycles/kernel/closure/bsdf_microfacet.h (bsdf_microfacet_ggx_eval_reflect)
// and bsdf_diffuse.h.
// Domain: alpha 1e-4..1 (the Roughness of the node is the square root of alpha).
// Symmetry: anisotropic, reciprocal.
// Known violations: only for kd + ks > 1.
struct blender_glossy : Takes<LobeWeights, Roughness> {
  static constexpr std::string_view name = "blender_glossy";
  static constexpr std::string_view family = "blender";
  static constexpr Kink kink = Kink::none;
  using Sampler = VisibleGgx;
  static constexpr NoViolations violations{};

  template <class S, class G>
  static std::array<S, 2> lobes(const Shape<S>& shape, const Geometry<G>& g) {
    return {S(1 / kPi), quotient(d_ggx(shape, g), v_separable_ggx(shape, g))};
  }
};

// Blender 3.4, Cycles: the Principled BSDF with distribution GGX and without transmission, subsurface,
// sheen, clearcoat and tint. The dielectric part has Burley's diffuse term of the base colour. The lobe is
// GGX with G1(wi) G1(wo), times F = lerp(F0, 1, H), F0 = lerp(f0(eta), base, metallic),
// H = (F_dielectric(cos_d) - f0)/(1 - f0).
// Source: Blender v3.4.0, intern/cycles/kernel/svm/closure.h (CLOSURE_BSDF_PRINCIPLED_ID),
// closure/bsdf_util.h (interpolate_fresnel_color), closure/bsdf_principled_diffuse.h.
// Domain: alpha 1e-4..1, eta 1..3 (the Specular of the node, f0/0.08, ends at eta 1.79).
// Symmetry: anisotropic, reciprocal.
struct blender_principled : Takes<BaseColour, Principled> {
  static constexpr std::string_view name = "blender_principled";
  static constexpr std::string_view family = "blender";
  static constexpr Kink kink = Kink::none;
  using Sampler = OfWidths<VisibleGgx>;
  static constexpr NoViolations violations{};

  template <class S, class G>
  static std::array<S, 2> lobes(const Shape<S>& shape, const Geometry<G>& g) {
    const Roughness<S> alpha = shape.widths();
    const S vd = quotient(d_ggx(alpha, g), v_separable_ggx(alpha, g));
    const S f0 = f0_of_index(shape.eta), dielectric = S(1) - shape.metallic;
    const S rise = (fresnel_dielectric(shape.eta, at_most(g.cos_d, G(1))) - f0) / (S(1) - f0);
    const S left = vd * (S(1) - rise);
    return {dielectric * burley_diffuse(alpha, g) * S(1 / kPi) + shape.metallic * left,
            f0 * dielectric * left + vd * rise};
  }
};

// Blender 4.3, Cycles: a Diffuse BSDF (roughness 0) and a Metallic BSDF (Fresnel type F82 Tint with a white
// Edge Tint, distribution GGX, not Multiscatter GGX), mixed by shaders. This equals cook_torrance: a white
// edge tint makes the F82 term 0.
// Source: Blender v4.3.0, intern/cycles/kernel/closure/bsdf_microfacet.h (bsdf_microfacet_eval, correlated
// masking; bsdf_microfacet_setup_fresnel_f82_tint) and svm/closure.h (CLOSURE_BSDF_PHYSICAL_CONDUCTOR,
// CLOSURE_BSDF_F82_CONDUCTOR).
// Domain: alpha 1e-4..1, f0 0..1.
// Symmetry: anisotropic, reciprocal.
// Known violations: only for kd + ks > 1.
struct blender_metallic : Takes<SchlickWeights, Roughness> {
  static constexpr std::string_view name = "blender_metallic";
  static constexpr std::string_view family = "blender";
  static constexpr Kink kink = Kink::none;
  using Sampler = VisibleGgx;
  static constexpr NoViolations violations{};

  template <class S, class G>
  static std::array<S, 3> lobes(const Shape<S>& shape, const Geometry<G>& g) {
    return cook_torrance::lobes(shape, g);
  }
};

}  // namespace brdf
