// The conductor of pbrt-v4 as a target.
#pragma once

#include "brdf/targets/parts.h"

namespace brdf {

// pbrt-v4: the materials `diffuse` and `conductor`, combined by `mix`:
// f = kd/pi + ks D G F/(4 cos_i cos_o), G = 1/(1 + Lambda(wi) + Lambda(wo)), F of the complex index n + i k.
// Source: pbrt-v4 5f7a6068, src/pbrt/util/scattering.h (TrowbridgeReitzDistribution, FrComplex),
// bxdfs.h:331 (ConductorBxDF::f), materials.h:493 (ConductorMaterial).
// Domain: alpha 1e-4..1 (pbrt treats a width below 1e-3 as a mirror), n and k 0..20.
// Symmetry: anisotropic, reciprocal.
// Known: this form is one channel with grey n and k. pbrt converts coloured n and k to smooth spectra and
// evaluates F at each wavelength (util/spectrum.h, RGBUnboundedSpectrum; materials.h,
// ConductorMaterial::GetBxDF). The result depends on all three channels: interop/pbrt_colour.h.
// "reflectance" instead of n and k would be exact at normal incidence only and is not used.
// Known violations: only for kd + ks > 1.
struct pbrt_conductor : Takes<LobeWeights, RoughConductor> {
  static constexpr std::string_view name = "pbrt_conductor";
  static constexpr std::string_view family = "pbrt";
  static constexpr Kink kink = Kink::none;
  using Sampler = OfWidths<VisibleGgx>;
  static constexpr NoViolations violations{};

  template <class S, class G>
  static std::array<S, 2> lobes(const Shape<S>& shape, const Geometry<G>& g) {
    const Roughness<S> alpha = shape.widths();
    return {S(1 / kPi), quotient(d_ggx(alpha, g), v_smith_ggx(alpha, g)) * fresnel_of(shape, g)};
  }
};

}  // namespace brdf
