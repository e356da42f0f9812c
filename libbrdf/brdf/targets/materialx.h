// The generalized Schlick model of MaterialX as a target.
#pragma once

#include "brdf/forms/oren_nayar.h"
#include "brdf/targets/parts.h"

namespace brdf {

// Returns a fit in x (the cosine of the viewing angle) and y (alpha), of second degree in each:
// c0 + c1 x + c2 y + c3 x y + c4 x^2 + c5 y^2 + c6 x^2 y + c7 x y^2 + c8 x^2 y^2.
template <class S, class G>
S biquadratic(const std::array<double, 9>& c, const G& x, const S& y) {
  const G constant = G(c[0]) + x * (G(c[1]) + x * G(c[4]));
  const G linear = G(c[2]) + x * (G(c[3]) + x * G(c[6]));
  const G quadratic = G(c[5]) + x * (G(c[7]) + x * G(c[8]));
  return constant + y * linear + square(y) * quadratic;
}

// A GGX lobe of MaterialX without its Fresnel term, with the albedo f0 a + f90 b of a lobe that rises from f0
// to f90.
template <class S>
struct MaterialxLobe {
  S value;  // D G/(4 cos_i cos_o)
  S a, b;

  // Returns the factor for light that is scattered several times: 1 + Fss (1 - E)/E, with E = a + b and
  // Fss = f0 + (f90 - f0)/21.
  S compensation(const S& f0, const S& f90) const {
    const S white = a + b;
    return S(1) + (f0 + (f90 - f0) * S(1.0 / 21)) * ((S(1) - white) / white);
  }
  // Returns the albedo in the direction of the viewer, compensation included.
  S albedo(const S& f0, const S& f90) const { return (f0 * a + f90 * b) * compensation(f0, f90); }
};

// Returns MaterialX's approximation: D has both widths, masking and albedo have their geometric mean. The
// two fractions are limited to 0..1.
// Source: mx_ggx_smith_G2, mx_ggx_dir_albedo_analytic, which is the default of the generator.
template <class S, class G>
MaterialxLobe<S> materialx_lobe(const Roughness<S>& widths, const Geometry<G>& g) {
  const S y = math::sqrt(widths.alpha_x * widths.alpha_y);
  const G& x = g.cos_o;
  const S a =
      biquadratic<S, G>({0.1003, -0.6303, 9.748, -2.038, 29.34, -8.245, -26.44, 19.99, -5.448}, x, y) /
      biquadratic<S, G>({1, -1.765, 8.263, 11.53, 28.96, -7.507, -36.11, 15.86, 33.37}, x, y);
  const S b =
      biquadratic<S, G>({0.9345, -2.323, 2.229, -3.748, 1.424, -0.7684, 1.436, 0.2913, 0.6286}, x, y) /
      biquadratic<S, G>({1, 0.2281, 15.94, -55.83, 13.08, 41.26, 54.9, 300.2, -285.1}, x, y);
  return {quotient(d_ggx(widths, g), v_smith_ggx(Roughness<S>{y, y}, g)), at_most(at_least(a, S(0)), S(1)),
          at_most(at_least(b, S(0)), S(1))};
}

inline constexpr ParameterInfo kDiffuseSlopeInfo{
    "sigma",    0,
    1,          0,
    1,          "rad",
    false,      "roughness of the diffuse part: standard deviation of the slope angle of its microfacets",
    Role::slope};

// f0 is not a weight here because the lobe is not linear in f0.
template <class T>
struct CompensatedSchlick {
  T alpha_x, alpha_y, f0, sigma;
  static constexpr auto fields() {
    return std::array{Field{&CompensatedSchlick::alpha_x, kAlongInfo},
                      Field{&CompensatedSchlick::alpha_y, kAcrossInfo},
                      Field{&CompensatedSchlick::f0,
                            ParameterInfo{"f0", 0, 1, 0.04, 1, "", false,
                                          "color0: Fresnel reflectance at normal incidence", Role::f0}},
                      Field{&CompensatedSchlick::sigma, kDiffuseSlopeInfo}};
  }
  Roughness<T> widths() const { return {alpha_x, alpha_y}; }
};

// MaterialX 1.39.6: an oren_nayar_diffuse_bsdf (without energy compensation) and a generalized_schlick_bsdf
// (color82 and color90 white, exponent 5), combined by `add`: f = kd ON(sigma)/pi + ks D G F
// comp/(4 cos_i cos_o). G is the correlated masking of a single alpha, the geometric mean of the widths.
// comp = 1 + Fss (1 - E)/E and Fss = f0 + (1 - f0)/21. E is the fitted albedo of a white lobe for the view
// direction.
// Source: AcademySoftwareFoundation/MaterialX 4177b2cbd (1.39.6),
// libraries/pbrlib/genglsl/mx_oren_nayar_diffuse_bsdf.glsl, mx_generalized_schlick_bsdf.glsl,
// mx_add_bsdf.glsl, lib/mx_microfacet_specular.glsl (mx_ggx_smith_G2, mx_ggx_dir_albedo_analytic,
// mx_ggx_energy_compensation, mx_fresnel_average), lib/mx_microfacet_diffuse.glsl.
// Earlier snapshots (915650af) had the Fresnel term at wi.h instead of Fss.
// Domain: alpha 1e-4..1 (the `roughness` of the node, unchanged), sigma 0..1.
// Symmetry: anisotropic, not reciprocal.
// Known violations: reciprocity, energy.
struct materialx_schlick : Takes<LobeWeights, CompensatedSchlick> {
  static constexpr std::string_view name = "materialx_schlick";
  static constexpr std::string_view family = "materialx";
  static constexpr Kink kink = Kink::azimuth;
  using Sampler = OfWidths<VisibleGgx>;
  static constexpr std::array violations{
      Violation{"reciprocity", "the energy compensation depends on cos_o only", "kd=0 ks=1 f0=1 alpha=1",
                89.5, 0.668073},
      Violation{"energy",
                "the compensation depends on the viewing direction, and the masking of an anisotropic lobe "
                "uses one width",
                "kd=0 ks=1 f0=1 alpha_x=1 alpha_y=0.0001", 89.5, 45.8305}};

  template <class S, class G>
  static std::array<S, 2> lobes(const Shape<S>& shape, const Geometry<G>& g) {
    const MaterialxLobe<S> lobe = materialx_lobe(shape.widths(), g);
    const S f = shape.f0 + (S(1) - shape.f0) * schlick(g);
    return {oren_nayar::lobes(SlopeDeviation<S>{shape.sigma}, g)[0],
            lobe.value * f * lobe.compensation(shape.f0, S(1))};
  }
};

}  // namespace brdf
