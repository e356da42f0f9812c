// The Phong form with several normalisations.
#pragma once

#include <cmath>

#include "brdf/form.h"
#include "brdf/forms/listing.h"
#include "brdf/samplers.h"

namespace brdf {

// Returns the albedo of the lobe at grazing incidence, n = shape[0].
inline double phong_grazing_albedo(std::span<const double> shape, double) {
  const double n = shape[0];
  return (n + 2) * std::exp(std::lgamma((n + 1) / 2) - std::lgamma(n / 2 + 2)) / (4 * std::sqrt(kPi));
}

// Phong 1975 as modified by Lewis 1994 (Lafortune and Willems 1994): f = kd/pi + ks (n+2)/(2 pi) (r.o)^n.
// Domain: exponent 0..1e6.
// Symmetry: isotropic, reciprocal (r.o is symmetric).
// Known violations: only for kd + ks > 1. The lobe loses energy towards grazing incidence (ks cos(theta)
// for large n).
struct phong : Takes<LobeWeights, Exponent> {
  static constexpr std::string_view name = "phong";
  static constexpr std::string_view family = "phong";
  static constexpr Accuracy accuracy{.in_float = {5.2e-6, 9.6e-6, 2.2e-5},
                                     .in_double = {8.4e-15, 1.6e-14, 5e-14}};
  static constexpr Kink kink = Kink::mirror_edge;
  static constexpr std::array albedos{
      ClosedAlbedo{0, 0, whole_albedo, "its normalisation"},
      ClosedAlbedo{90, 90, phong_grazing_albedo, "a ratio of gamma functions at grazing"}};
  using Sampler = MirrorCosine;
  static constexpr NoViolations violations{};

  template <class S, class G>
  static std::array<S, 2> lobes(const Shape<S>& shape, const Geometry<G>& g) {
    const S k = (shape.exponent + S(2)) * S(1 / (2 * kPi));
    return {S(1 / kPi), k * mirror_cosine_power(shape.exponent, g)};
  }
};

// Phong as printed in the thesis: f = kd/pi + ks (r.o)^n, without normalisation of the lobe.
// Domain: exponent 0..1e6.
// Symmetry: isotropic, reciprocal (r.o is symmetric).
// Known violations: energy. The lobe reflects 2 pi/(n+2) at normal incidence, which exceeds 1 for n < 4.28.
struct phong_unnormalised : Takes<LobeWeights, Exponent> {
  static constexpr std::string_view name = "phong_unnormalised";
  static constexpr std::string_view family = "phong";
  static constexpr Accuracy accuracy{.in_float = {3.6e-6, 7.2e-6, 2.4e-5},
                                     .in_double = {7.3e-15, 9.7e-15, 3.2e-14}};
  static constexpr Kink kink = Kink::mirror_edge;
  using Sampler = MirrorCosine;
  static constexpr std::array violations{
      Violation{"energy", "lobe albedo 2 pi/(n+2) at normal incidence: above 1 for n < 4.28",
                "kd=0 ks=1 exponent=0", 0, kPi}};

  template <class S, class G>
  static std::array<S, 2> lobes(const Shape<S>& shape, const Geometry<G>& g) {
    return {S(1 / kPi), mirror_cosine_power(shape.exponent, g)};
  }
};

// Phong's shading of 1975 as a BRDF. The shading does not multiply the lobe by the cosine; f is therefore
// the lobe divided by cos_i: f = kd/pi + ks (n+1)/(2 pi) (r.o)^n / cos_i (discussed by Lewis 1994).
// Domain: exponent 0..1e6.
// Symmetry: isotropic, not reciprocal.
// Known violations: reciprocity; energy with the light fixed: (n+1)/(n+2) at normal incidence, then growing
// as 1/cos_i. (With the viewer fixed the albedo is 1 at normal incidence and 1/2 at grazing incidence.)
struct phong_classic : Takes<LobeWeights, Exponent> {
  static constexpr std::string_view name = "phong_classic";
  static constexpr std::string_view family = "phong";
  static constexpr Accuracy accuracy{.in_float = {5.1e-6, 7.8e-6, 1.9e-5},
                                     .in_double = {9.6e-15, 2e-14, 5e-14}};
  static constexpr Kink kink = Kink::mirror_edge;
  using Sampler = MirrorCosine;
  static constexpr std::array violations{
      Violation{"energy", "albedo at fixed incidence grows as 1/cos_i", "kd=0 ks=1 exponent=0", 89.5, 28.897},
      Violation{"reciprocity", "divided by cos_i only", "kd=0 ks=1 exponent=0", 89.5, 0.99127},
      Violation{"continuity", "the lobe lacks the factor cos_i", "kd=0 ks=1 exponent=0", 0, 1}};

  template <class S, class G>
  static std::array<S, 2> lobes(const Shape<S>& shape, const Geometry<G>& g) {
    const S k = (shape.exponent + S(1)) * S(1 / (2 * kPi));
    return {S(1 / kPi), k * mirror_cosine_power(shape.exponent, g) / g.cos_i};
  }
};

// The listing of the thesis: f cos_i = albedo/pi + (n.r)^15 F0 cos_i. n.r equals n.l; the "highlight" thus
// does not depend on the viewer. The diffuse term has no cosine.
// Domain: albedo and metallic 0..1.
// Symmetry: isotropic, not reciprocal.
// Known violations: reciprocity; energy: (albedo + pi F0 cos_i^16)/cos_i with the light fixed, 2 albedo + 2
// pi/17 F0 with the viewer fixed.
struct phong_as_coded : Takes<Albedo, Metallic> {
  static constexpr std::string_view name = "phong_as_coded";
  static constexpr std::string_view family = "phong";
  static constexpr Accuracy accuracy{.in_float = {1.5e-6, 0, 0}, .in_double = {3.4e-15, 0, 0}};
  static constexpr Kink kink = Kink::mirror_edge;
  using Sampler = Hemisphere;
  static constexpr std::array violations{
      Violation{"energy", "the diffuse term lacks the factor cos_i: albedo (albedo + pi F0 cos_i^16)/cos_i",
                "albedo=1 metallic=1", 89.5, 114.593},
      Violation{"reciprocity", "depends on cos_i only", "albedo=0 metallic=0", 89.5, 1},
      Violation{"continuity", "the diffuse term lacks the factor cos_i", "albedo=1 metallic=0", 0, 0.983}};

  template <class S, class G>
  static S value_cos(const Weights<S>& w, const Weights<S>&, const Shape<S>& shape, const Geometry<G>& g) {
    const G cos_i16 = square(square(square(square(g.cos_i))));
    return w.albedo * S(1 / kPi) + f0_as_coded(w, shape.metallic) * cos_i16;
  }
};

}  // namespace brdf
