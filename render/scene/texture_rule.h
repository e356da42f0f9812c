// How texture maps drive the parameters of any reflectance: the one rule, for C++ and (traced) for the
// shaders.
//
// With albedo a, roughness r and metalness m of the maps (where there is no such map, a is the diffuse weight
// and m is 0), 0.03 being the thesis's reflectance of dielectrics, by role or map of the parameter:
//
//   diffuse weight, alone              a
//   diffuse weight beside a specular   0.97 a (1 - m)
//   specular weight beside an f0       1
//   specular weight without; f0        0.03 + (a - 0.03) m
//   width, width across                max(r^2, 1e-3)
//   exponent, exponent across          2/width^2 - 2, at most 1e4: the cosine lobe as wide as that
//   slope                              r^2
//   mapped to roughness, metallic      r, m
//
// A parameter is driven only where its map exists: weights by albedo or metallic, shapes by roughness or
// metallic.
#pragma once

#include "brdf/reflectance.h"

namespace brdf::render {

// The rules above, in their order; `own`: the parameter keeps its value.
enum class Rule { own, albedo, diffuse, one, specular, width, exponent, slope, roughness, metallic };
inline constexpr int kRuleCount = 10;

inline constexpr double kDielectricReflectance = 0.03;
// Cosine of a mapped normal with the viewer, at least: one that faced away would leave black specks along the
// edge of the object.
inline constexpr double kLeastFacing = 0.05;
// The same of a mesh's own normal: interpolated, it faces away at a silhouette from a viewer who sees the
// triangle's front. Small, so that a plane seen at 89 degrees keeps its normal.
inline constexpr double kLeastSeen = 0.01;

template <class S>
S driven(Rule rule, const S& own, const S& albedo, const S& roughness, const S& metallic) {
  const S width = at_least(roughness * roughness, S(1e-3));
  switch (rule) {
    case Rule::albedo:
      return albedo;
    case Rule::diffuse:
      return S(1 - kDielectricReflectance) * albedo * (S(1) - metallic);
    case Rule::one:
      return S(1);
    case Rule::specular:
      return S(kDielectricReflectance) + (albedo - S(kDielectricReflectance)) * metallic;
    case Rule::width:
      return width;
    case Rule::exponent:
      return at_most(S(2) / (width * width) - S(2), S(1e4));
    case Rule::slope:
      return roughness * roughness;
    case Rule::roughness:
      return roughness;
    case Rule::metallic:
      return metallic;
    case Rule::own:
      break;
  }
  return own;
}

// The rule for a parameter of this reflectance.
inline Rule rule_of(const ParameterInfo& parameter, const ReflectanceInfo& of) {
  if (parameter.map == Map::roughness) return Rule::roughness;
  if (parameter.map == Map::metallic) return Rule::metallic;
  switch (parameter.role) {
    case Role::diffuse:
      return of.weight_index(Role::specular) < 0 ? Rule::albedo : Rule::diffuse;
    case Role::specular:
      return of.weight_index(Role::f0) < 0 ? Rule::specular : Rule::one;
    case Role::f0:
      return Rule::specular;
    case Role::width:
    case Role::width_across:
      return Rule::width;
    case Role::exponent:
    case Role::exponent_across:
      return Rule::exponent;
    case Role::slope:
      return Rule::slope;
    case Role::index:
    case Role::extinction:
    case Role::tint:
    case Role::other:
      break;
  }
  return Rule::own;
}

}  // namespace brdf::render
