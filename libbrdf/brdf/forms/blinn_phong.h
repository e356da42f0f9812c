// The Blinn-Phong form with four normalisations.
#pragma once

#include "brdf/form.h"
#include "brdf/forms/listing.h"
#include "brdf/samplers.h"

namespace brdf {

// Blinn 1977 with the exact normalisation: f = kd/pi + ks k (n.h)^n, k = (n+2)(n+4)/(8 pi (2^(-n/2) + n)).
// The albedo of the lobe is ks at normal incidence.
// Domain: exponent 0..1e6.
// Symmetry: isotropic, reciprocal.
// Known violations: only for kd + ks > 1. The lobe loses energy towards grazing incidence
// (ks cos^2(theta) for large n).
struct blinn_phong : Takes<LobeWeights, Exponent> {
  static constexpr std::string_view name = "blinn_phong";
  static constexpr std::string_view family = "blinn_phong";
  static constexpr Accuracy accuracy{.in_float = {4.8e-6, 7.1e-6, 1.8e-5},
                                     .in_double = {8.7e-15, 1.1e-14, 3.1e-14}};
  static constexpr Kink kink = Kink::none;
  static constexpr std::array albedos{ClosedAlbedo{0, 0, whole_albedo, "its normalisation"}};
  using Sampler = HalfCosine;
  static constexpr NoViolations violations{};

  template <class S, class G>
  static std::array<S, 2> lobes(const Shape<S>& shape, const Geometry<G>& g) {
    const S& n = shape.exponent;
    const S k = (n + S(2)) * (n + S(4)) / (S(8 * kPi) * (math::exp(n * S(-0.34657359027997265)) + n));
    return {S(1 / kPi), k * half_cosine_power(n, g)};
  }
};

// Blinn-Phong with the popular approximate normalisation: f = kd/pi + ks (n+8)/(8 pi) (n.h)^n
// (Akenine-Moller, Haines and Hoffman 2008).
// Domain: exponent 0..1e6.
// Symmetry: isotropic, reciprocal.
// Known violations: energy at normal incidence for every n > 0, at most 1.075201 at n = 8.764.
struct blinn_phong_n8 : Takes<LobeWeights, Exponent> {
  static constexpr std::string_view name = "blinn_phong_n8";
  static constexpr std::string_view family = "blinn_phong";
  static constexpr Accuracy accuracy{.in_float = {5e-6, 7.8e-6, 1.9e-5},
                                     .in_double = {9.4e-15, 1.4e-14, 3.5e-14}};
  static constexpr Kink kink = Kink::none;
  using Sampler = HalfCosine;
  static constexpr std::array violations{Violation{"energy",
                                                   "albedo above 1 at normal incidence, at most 1.0752",
                                                   "kd=0 ks=1 exponent=8.764", 0, 1.075201}};

  template <class S, class G>
  static std::array<S, 2> lobes(const Shape<S>& shape, const Geometry<G>& g) {
    const S k = (shape.exponent + S(8)) * S(1 / (8 * kPi));
    return {S(1 / kPi), k * half_cosine_power(shape.exponent, g)};
  }
};

// Blinn-Phong as printed in the thesis: f = kd + ks (n.h)^n.
// Domain: exponent 0..1e6.
// Symmetry: isotropic, reciprocal.
// Known violations: energy. The diffuse term lacks 1/pi and integrates to pi kd; the lobe is not normalised.
struct blinn_phong_unnormalised : Takes<LobeWeights, Exponent> {
  static constexpr std::string_view name = "blinn_phong_unnormalised";
  static constexpr std::string_view family = "blinn_phong";
  static constexpr Accuracy accuracy{.in_float = {4.3e-6, 7.4e-6, 1.8e-5},
                                     .in_double = {6e-15, 1.1e-14, 1.9e-14}};
  static constexpr Kink kink = Kink::none;
  using Sampler = HalfCosine;
  static constexpr std::array violations{
      Violation{"energy", "the diffuse term integrates to pi kd", "kd=1 ks=0 exponent=20", 0, kPi}};

  template <class S, class G>
  static std::array<S, 2> lobes(const Shape<S>& shape, const Geometry<G>& g) {
    return {S(1), half_cosine_power(shape.exponent, g)};
  }
};

// The listing of the thesis: f cos_i = albedo/pi + (n.h)^5 F0 cos_i. The diffuse term has no cosine.
// Domain: albedo and metallic 0..1.
// Symmetry: isotropic, not reciprocal.
// Known violations: reciprocity; energy, growing as 1/cos_i.
struct blinn_phong_as_coded : Takes<Albedo, Metallic> {
  static constexpr std::string_view name = "blinn_phong_as_coded";
  static constexpr std::string_view family = "blinn_phong";
  static constexpr Accuracy accuracy{.in_float = {1.8e-6, 1.8e-6, 1.8e-6},
                                     .in_double = {3.4e-15, 3.6e-15, 3.6e-15}};
  static constexpr Kink kink = Kink::none;
  using Sampler = Hemisphere;
  static constexpr std::array violations{
      Violation{"energy", "the diffuse term lacks the factor cos_i: albedo above 1, growing as 1/cos_i",
                "albedo=1 metallic=1", 89.5, 115.001},
      Violation{"reciprocity", "the diffuse term is divided by cos_i only", "albedo=1 metallic=0", 89.5,
                0.99113},
      Violation{"continuity", "the diffuse term lacks the factor cos_i", "albedo=1 metallic=0", 0, 0.996}};

  template <class S, class G>
  static S value_cos(const Weights<S>& w, const Weights<S>&, const Shape<S>& shape, const Geometry<G>& g) {
    const G cos_h = g.h.z / (G(2) * g.cos_d);
    const G cos_h5 = square(square(cos_h)) * cos_h;
    return w.albedo * S(1 / kPi) + f0_as_coded(w, shape.metallic) * (cos_h5 * g.cos_i);
  }
};

}  // namespace brdf
