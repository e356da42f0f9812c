#pragma once

#include "brdf/targets/parts.h"

namespace brdf {

// pbrt-v4: the materials `diffuse` and `conductor`, put together by `mix`:
// f = kd/pi + ks D G F/(4 cos_i cos_o), G = 1/(1 + Lambda(wi) + Lambda(wo)), F of the complex index n + i k.
// Source: pbrt-v4 5f7a6068, src/pbrt/util/scattering.h (TrowbridgeReitzDistribution, FrComplex), bxdfs.h:331
// (ConductorBxDF::f), materials.h:493 (ConductorMaterial).
// Domain: alpha 1e-4..1 (a width below 1e-3 is a mirror there), n and k 0..20.
// Symmetry: anisotropic, reciprocal.
// Known: this is a channel of grey n and k. Of coloured ones pbrt makes smooth spectra and takes F at each
// wavelength
// (util/spectrum.h, RGBUnboundedSpectrum; materials.h, ConductorMaterial::GetBxDF), which depends on all
// three channels:
// interop/pbrt_colour.h. "reflectance" in place of n and k, which is exact along the normal alone, is not
// used.
// Known violations: none for kd + ks <= 1.
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
