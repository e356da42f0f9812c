// How texture maps drive the parameters of any form: the one rule, for C++ and (traced) for the shaders.
//
// With albedo a, roughness r and metalness m of the maps (m = 0 and a = the form's first weight where there
// is no such map), 0.03 being the thesis's reflectance of dielectrics:
//   rho, albedo          a
//   kd                   0.97 a (1 - m)
//   ks (form has f0)     1
//   f0, ks (without f0)  0.03 + (a - 0.03) m
//   alpha_x, alpha_y     max(r^2, 1e-3)
//   exponent             2/alpha^2 - 2, at most 1e4    (the cosine lobe as wide as a slope distribution of
//   width alpha) sigma                r^2 roughness, metallic  r, m
// A parameter is driven only where its map exists: weights
// by albedo or metallic, shapes by roughness or metallic.
#pragma once

#include <string_view>

#include "brdf/scalar.h"

namespace brdf::render {

enum class Role { own, reflectance, diffuse, unity, specular, alpha, exponent, sigma, roughness, metallic };
inline constexpr int kRoleCount = 10;

inline constexpr double kDielectricReflectance = 0.03;

template <class S>
S driven(Role role, const S& own, const S& albedo, const S& roughness, const S& metallic) {
  const S alpha = at_least(roughness * roughness, S(1e-3));
  switch (role) {
    case Role::reflectance:
      return albedo;
    case Role::diffuse:
      return S(1 - kDielectricReflectance) * albedo * (S(1) - metallic);
    case Role::unity:
      return S(1);
    case Role::specular:
      return S(kDielectricReflectance) + (albedo - S(kDielectricReflectance)) * metallic;
    case Role::alpha:
      return alpha;
    case Role::exponent:
      return at_most(S(2) / (alpha * alpha) - S(2), S(1e4));
    case Role::sigma:
      return roughness * roughness;
    case Role::roughness:
      return roughness;
    case Role::metallic:
      return metallic;
    case Role::own:
      break;
  }
  return own;
}

// The role of a parameter by its name in the form's table; `has_f0`: whether the form has a parameter f0.
constexpr Role role_of(std::string_view parameter, bool has_f0) {
  if (parameter == "rho" || parameter == "albedo") return Role::reflectance;
  if (parameter == "kd") return Role::diffuse;
  if (parameter == "ks") return has_f0 ? Role::unity : Role::specular;
  if (parameter == "f0") return Role::specular;
  if (parameter == "alpha_x" || parameter == "alpha_y") return Role::alpha;
  if (parameter == "exponent") return Role::exponent;
  if (parameter == "sigma") return Role::sigma;
  if (parameter == "roughness") return Role::roughness;
  if (parameter == "metallic") return Role::metallic;
  return Role::own;
}

}  // namespace brdf::render
