// The rule by which texture maps drive the parameters of any reflectance, with one definition for C++ and
// (traced) for the shaders.
//
// The maps give albedo a, roughness r and metalness m; without such a map, a is the diffuse weight and m is
// 0. The constant 0.03 is the thesis's reflectance of dielectrics. The value depends on the role or the map
// of the parameter:
//
//   diffuse weight, alone              a
//   diffuse weight with a specular one 0.97 a (1 - m)
//   specular weight with an f0         1
//   specular weight without; f0        0.03 + (a - 0.03) m
//   width, width across                max(r^2, 1e-3)
//   exponent, exponent across          2/width^2 - 2, at most 1e4: a cosine lobe of the same width
//   slope                              r^2
//   mapped to roughness, metallic      r, m
//
// A parameter is driven only if its map exists: weights by albedo or metallic, shapes by roughness or
// metallic.
#pragma once

#include "brdf/reflectance.h"

namespace brdf::render {

// The rules above, in the same order; `own`: the parameter keeps its value.
enum class Rule { own, albedo, diffuse, one, specular, width, exponent, slope, roughness, metallic };
inline constexpr int kRuleCount = 10;

inline constexpr double kDielectricReflectance = 0.03;
// Lower bound of the cosine between a mapped normal and the viewer. A normal that faces away would leave
// black specks along the edge of the object.
inline constexpr double kLeastFacing = 0.05;
// Lower bound of the same cosine for the interpolated normal of a mesh, which may face away at a silhouette
// although the viewer sees the front of the triangle. The bound is small, so that a plane seen at 89 degrees
// keeps its normal.
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

// Returns the rule for a parameter of this reflectance.
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
