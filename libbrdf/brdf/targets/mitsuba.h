// Models of Mitsuba 3 as targets.
#pragma once

#include "brdf/targets/parts.h"

namespace brdf {

// Mitsuba 3: `roughconductor` with distribution ggx, and `diffuse`, mixed by `blendbsdf`:
// f = kd/pi + ks D G1(wi) G1(wo) F/(4 cos_i cos_o), with F of the complex index n + i k.
// Source: Mitsuba 3 b45b0a930, src/bsdfs/roughconductor.cpp:315- (eval), include/mitsuba/render/microfacet.h
// (G, smith_g1), include/mitsuba/render/fresnel.h (fresnel_conductor), src/bsdfs/diffuse.cpp:139.
// Not covered: the spectral variants, which convert colours to spectra like pbrt
// (src/core/properties.cpp:669-698). The rgb variants compute by channel.
// Domain: alpha 1e-4..1, n and k 0..20.
// Symmetry: anisotropic, reciprocal.
// Known violations: only for kd + ks > 1.
struct mitsuba_roughconductor : Takes<LobeWeights, RoughConductor> {
  static constexpr std::string_view name = "mitsuba_roughconductor";
  static constexpr std::string_view family = "mitsuba";
  static constexpr Kink kink = Kink::none;
  using Sampler = OfWidths<VisibleGgx>;
  static constexpr NoViolations violations{};

  template <class S, class G>
  static std::array<S, 2> lobes(const Shape<S>& shape, const Geometry<G>& g) {
    const Roughness<S> alpha = shape.widths();
    return {S(1 / kPi), quotient(d_ggx(alpha, g), v_separable_ggx(alpha, g)) * fresnel_of(shape, g)};
  }
};

// Mitsuba 3: `principled` without tint, transmission, sheen, clearcoat and flatness. The dielectric part
// has Burley's diffuse term of the base colour. The lobe is GGX with G1(wi) G1(wo), times
// F = (1 - metallic) F_dielectric(eta) + metallic (base + (1 - base)(1 - cos_d)^5).
// Source: Mitsuba 3 b45b0a930, src/bsdfs/principled.cpp:493- (eval), principledhelpers.h:239
// (principled_fresnel), :320 (calc_dist_params: the widths are at least 0.001).
// Domain: alpha 1e-4..1, eta 1..3.
// Symmetry: anisotropic, reciprocal.
struct mitsuba_principled : Takes<BaseColour, Principled> {
  static constexpr std::string_view name = "mitsuba_principled";
  static constexpr std::string_view family = "mitsuba";
  static constexpr Kink kink = Kink::none;
  using Sampler = OfWidths<VisibleGgx>;
  static constexpr NoViolations violations{};

  template <class S, class G>
  static std::array<S, 2> lobes(const Shape<S>& shape, const Geometry<G>& g) {
    const Roughness<S> alpha = shape.widths();
    const S vd = quotient(d_ggx(alpha, g), v_separable_ggx(alpha, g));
    const S dielectric = S(1) - shape.metallic;
    const G rise = schlick(g);
    const S f = fresnel_dielectric(shape.eta, at_most(g.cos_d, G(1)));
    return {dielectric * burley_diffuse(alpha, g) * S(1 / kPi) + shape.metallic * vd * (G(1) - rise),
            vd * (dielectric * f + shape.metallic * rise)};
  }
};

}  // namespace brdf
