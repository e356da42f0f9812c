// Retroreflective lobes: tapes, road marks, safety cloth.
#pragma once

#include "brdf/forms/cook_torrance.h"

namespace brdf {

// Returns the geometry of the same light and the view after half a turn about the normal.
template <class G>
Geometry<G> turned_back(const Geometry<G>& g) {
  return geometry(g.wi, Vec3<G>{-g.wo.x, -g.wo.y, g.wo.z});
}

// Samples a lobe about the direction of the light itself: the lobe's own sampler with the view turned.
template <class Sampler>
struct Retroreflected {
  template <class S, class T>
  static Vec3<T> sample(const S& s, T u1, T u2, const Vec3<T>& wo) {
    return Sampler::sample(s, u1, u2, Vec3<T>{-wo.x, -wo.y, wo.z});
  }
  template <class S, class T>
  static T pdf(const S& s, const Geometry<T>& g) {
    return Sampler::pdf(s, turned_back(g));
  }
};

template <class T>
struct RetroWeight {
  T kr;
  static constexpr auto fields() {
    return std::array{
        Field{&RetroWeight::kr, ParameterInfo{"kr", 0, kWeightMax, 0.5, 1, "", false,
                                              "weight of the retroreflective lobe", Role::specular}}};
  }
  constexpr std::array<T, 1> linear() const { return {kr}; }
  static constexpr RetroWeight from_linear(const std::array<T, 1>& w) { return {w[0]}; }
};

// The adaptor: the lobe of F, seen with the view turned by half a turn about the normal, without the diffuse
// term and with a Fresnel reflectance of 1 (a mirror behind the surface). M (x, y, z) = (-x, -y, z) maps the
// hemisphere to itself and keeps cosines and solid angles, so albedo, energy, facets and the density of the
// sampler are those of F.
template <class F>
struct Retro : Takes<RetroWeight, F::template Shape> {
  static constexpr std::string_view family = "retroreflective";
  static constexpr bool about_light = true;
  static constexpr Accuracy accuracy = F::accuracy;
  static constexpr Kink kink = F::kink;
  using Facets = typename F::Facets;
  using Sampler = Retroreflected<typename F::Sampler>;
  static constexpr NoViolations violations{};

  template <class S, class G>
  static std::array<S, 1> lobes(const typename F::template Shape<S>& shape, const Geometry<G>& g) {
    return {F::lobes(shape, turned_back(g))[1]};
  }
};

// Portsmouth, Raab, Belcour and Liu 2026 (JCGT 15(1), 60-75): f(wi, wo) = kr F(wi, M wo) with the lobe F of
// cook_torrance (GGX, Smith's masking) at a Fresnel reflectance of 1. A material adds it to other terms.
// Domain: alpha 1e-4..1.
// Symmetry: anisotropic, reciprocal.
// Known violations: only for kr > 1. Single scattering loses light as cook_torrance does.
struct retro : Retro<cook_torrance> {
  static constexpr std::string_view name = "retro";
};

// The same with the lobe of cook_torrance_beckmann.
// Domain: alpha 1e-4..1.
// Symmetry: anisotropic, reciprocal.
// Known violations: only for kr > 1.
struct retro_beckmann : Retro<cook_torrance_beckmann> {
  static constexpr std::string_view name = "retro_beckmann";
  static constexpr Accuracy accuracy{.in_float = {5.5e-6, 8.8e-6, 1.7e-5},
                                     .in_double = {8.4e-15, 1.2e-14, 3e-14}};
};

}  // namespace brdf
