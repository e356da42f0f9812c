// The common parts of the shader listings of the thesis (the `_as_coded` forms): their parameters, F0 and kD.
//
// A listing returns shaded radiance. At radiance 1 and without its ambient term that value is f_r cos_i;
// these forms therefore define value_cos. Values are clamped only if the listing clamps them.
#pragma once

#include "brdf/form.h"
#include "brdf/microfacet.h"

namespace brdf {

template <class T>
struct Albedo {
  T albedo;
  static constexpr auto fields() {
    return std::array{Field{&Albedo::albedo, ParameterInfo{"albedo", 0, 1, 0.5, 1, "", false,
                                                           "colour of the surface", Role::diffuse}}};
  }
};

inline constexpr ParameterInfo kMetallicInfo{
    "metallic", 0, 1, 0, 1, "", false, "0 for a dielectric, 1 for a metal", Role::other, Map::metallic};

template <class T>
struct Metallic {
  T metallic;
  static constexpr auto fields() { return std::array{Field{&Metallic::metallic, kMetallicInfo}}; }
};

// Returns F0 = lerp(0.03, albedo, metallic).
template <class S>
S f0_as_coded(const Albedo<S>& w, const S& metallic) {
  return S(0.03) * (S(1) - metallic) + metallic * w.albedo;
}

// Returns 1 - F0, computed without the difference.
template <class S>
S f0_rest_as_coded(const Albedo<S>& w, const S& metallic) {
  return S(0.97) * (S(1) - metallic) + metallic * (S(1) - w.albedo);
}

// Returns Schlick's Fresnel with that F0 at h.v.
template <class S, class G>
S schlick_as_coded(const Albedo<S>& w, const S& metallic, const Geometry<G>& g) {
  const Vec3<G> d = g.wo - g.wi;
  const G x = G(0.25) * dot(d, d) / (G(1) + g.cos_d);  // 1 - cos_d; the only term if F0 is 0
  return f0_as_coded(w, metallic) + f0_rest_as_coded(w, metallic) * (square(square(x)) * x);
}

// Returns kD = (1 - F)(1 - metallic). The listing assigns kD to a scalar and thus uses the red component
// for all channels. 1 - F = (1 - F0)(1 - (1 - c)^5) with the last factor expanded, which is 5c towards
// grazing incidence.
template <class S, class G>
S diffuse_share_as_coded(const Albedo<S>& first, const S& metallic, const Geometry<G>& g) {
  const G c = at_most(g.cos_d, G(1));
  const G y = G(1) - c;
  const G left = c * (G(1) + y * (G(1) + y * (G(1) + y * (G(1) + y))));
  return f0_rest_as_coded(first, metallic) * (S(1) - metallic) * left;
}

}  // namespace brdf
