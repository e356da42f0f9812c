// Parameter tables. The table in a struct of parameters is the only place that defines their names, ranges,
// roles and meaning. Command-line flags, JSON keys, solver bounds, sliders, shader arguments and the
// documentation are derived from it.
#pragma once

#include <array>
#include <cmath>
#include <span>
#include <string_view>
#include <utility>

#include "brdf/names.h"
#include "brdf/scalar.h"

namespace brdf {

// The meaning of a parameter, independent of its name. A role does not imply a weight or a shape parameter.
enum class Role {
  diffuse,          // diffuse reflectance
  specular,         // weight of the lobe
  f0,               // Fresnel reflectance at normal incidence
  width,            // of the slope distribution along the tangent
  width_across,     // the same across the tangent
  exponent,         // of a cosine, along the tangent
  exponent_across,  // the same across the tangent
  slope,            // standard deviation of the slope angle of the microfacets
  index,            // of refraction, real part
  extinction,       // its imaginary part
  tint,             // factor of the reflectance at normal incidence, by colour
  other
};

// Roles in pairs: along and across the tangent.
inline constexpr std::array<std::array<Role, 2>, 2> kAxisRoles{
    {{Role::width, Role::width_across}, {Role::exponent, Role::exponent_across}}};

template <>
inline constexpr std::array<std::string_view, 12> kNames<Role>{
    "diffuse",         "specular", "f0",    "width",      "width_across", "exponent",
    "exponent_across", "slope",    "index", "extinction", "tint",         "other"};

// Returns true if the parameter determines the reflectance at normal incidence, by Fresnel's equations or
// by an approximation of them.
constexpr bool is_fresnel(Role role) {
  switch (role) {
    case Role::f0:
    case Role::index:
    case Role::extinction:
    case Role::tint:
      return true;
    case Role::diffuse:
    case Role::specular:
    case Role::width:
    case Role::width_across:
    case Role::exponent:
    case Role::exponent_across:
    case Role::slope:
    case Role::other:
      break;
  }
  return false;
}

// The texture map that holds the value of a parameter unchanged. Without such a map the role of the
// parameter decides (render/scene/texture_rule.h).
enum class Map { none, roughness, metallic };

struct ParameterInfo {
  std::string_view name;
  double min, max, initial;
  // Upper end of sliders and random tests. Values from here up to max are permitted.
  double usual_max;
  std::string_view unit;  // "" if dimensionless
  bool log_scale;         // searched and shown on a logarithmic scale
  std::string_view doc;
  Role role = Role::other;
  Map map = Map::none;
  bool whole = false;  // whole numbers only: a count, a choice, or a Boolean (0 and 1)
};

// Returns the permitted value nearest to x. x must lie between the minimum and the maximum of the parameter.
inline double nearest_value(const ParameterInfo& p, double x) {
  return p.whole ? std::floor(x + 0.5) : x;
}

// Returns the lower end of sliders and random tests. A range of both signs is used symmetrically.
constexpr double usual_min(const ParameterInfo& p) {
  return p.min < -p.usual_max ? -p.usual_max : p.min;
}

// Returns the position in a table, by name or role, or -1 if there is no such parameter.
constexpr int parameter_index(std::span<const ParameterInfo> table, std::string_view name) {
  for (std::size_t k = 0; k < table.size(); ++k)
    if (table[k].name == name) return int(k);
  return -1;
}
constexpr int parameter_index(std::span<const ParameterInfo> table, Role role) {
  for (std::size_t k = 0; k < table.size(); ++k)
    if (table[k].role == role) return int(k);
  return -1;
}

template <class P, class T>
struct Field {
  T P::*member;
  ParameterInfo info;
};
template <class P, class T>
Field(T P::*, ParameterInfo) -> Field<P, T>;

// Parameters of a form. `fields()` lists every member, in order.
template <class P>
concept ParameterStruct = requires {
  { P::fields().size() } -> std::convertible_to<std::size_t>;
};

template <class P>
inline constexpr std::size_t parameter_count = P::fields().size();

// Returns true if the table lists each member once, with a valid range. Asserted for every form at compile
// time.
template <class P, class T>
consteval bool table_is_sound() {
  constexpr auto fields = P::fields();
  if constexpr (fields.size() > 0) {
    if (sizeof(P) != fields.size() * sizeof(T)) return false;
    for (std::size_t i = 0; i < fields.size(); ++i) {
      const ParameterInfo& p = fields[i].info;
      if (!(p.min <= p.initial && p.initial <= p.usual_max && p.usual_max <= p.max)) return false;
      if (p.name.empty() || p.doc.empty() || (p.log_scale && p.max <= 0)) return false;
      for (std::size_t j = 0; j < i; ++j)
        if (fields[j].info.name == p.name || fields[j].member == fields[i].member) return false;
    }
    const auto has = [&](Role role) {
      for (const auto& field : fields)
        if (field.info.role == role) return true;
      return false;
    };
    for (const auto& [along, across] : kAxisRoles)
      if (has(across) && !has(along)) return false;
  }
  return true;
}

// Returns the values of a struct in table order. Expanded by a template, because compilers keep a loop over
// many parameters, and a loop body that contains a loop does not vectorise.
template <class T, ParameterStruct P>
constexpr std::array<T, parameter_count<P>> to_values(const P& p) {
  constexpr auto fields = P::fields();
  return [&]<std::size_t... k>(std::index_sequence<k...>) {
    return std::array<T, parameter_count<P>>{p.*(fields[k].member)...};
  }(std::make_index_sequence<parameter_count<P>>{});
}

// Returns the struct with these values, given in table order.
template <class P, class T>
constexpr P from_values(std::span<const T> values) {
  constexpr auto fields = P::fields();
  P p{};
  [&]<std::size_t... k>(std::index_sequence<k...>) {
    ((p.*(fields[k].member) = values[k]), ...);
  }(std::make_index_sequence<fields.size()>{});
  return p;
}

// --- Parameter sets that several forms share -------------------------------------------------------------

inline constexpr double kWeightMax = 1000;  // uncalibrated measurements may need much more than 1

template <class T>
struct NoShape {
  static constexpr std::array<Field<NoShape, T>, 0> fields() { return {}; }
};

// linear() returns the weights of a form's lobes; from_linear() is its inverse.
template <class T>
struct DiffuseWeights {
  T rho;
  static constexpr auto fields() {
    return std::array{Field{&DiffuseWeights::rho, ParameterInfo{"rho", 0, kWeightMax, 0.5, 1, "", false,
                                                                "diffuse reflectance", Role::diffuse}}};
  }
  constexpr std::array<T, 1> linear() const { return {rho}; }
  static constexpr DiffuseWeights from_linear(const std::array<T, 1>& w) { return {w[0]}; }
};

inline constexpr ParameterInfo kDiffuseInfo{
    "kd", 0, kWeightMax, 0.5, 1, "", false, "weight of the diffuse term", Role::diffuse};
inline constexpr ParameterInfo kSpecularInfo{
    "ks", 0, kWeightMax, 0.5, 1, "", false, "weight of the specular lobe", Role::specular};

template <class T>
struct LobeWeights {
  T kd, ks;
  static constexpr auto fields() {
    return std::array{Field{&LobeWeights::kd, kDiffuseInfo}, Field{&LobeWeights::ks, kSpecularInfo}};
  }
  constexpr std::array<T, 2> linear() const { return {kd, ks}; }
  static constexpr LobeWeights from_linear(const std::array<T, 2>& w) { return {w[0], w[1]}; }
};

// Schlick's F = f0 + (1 - f0) s, split into two lobes: the form is linear in (kd, ks f0, ks (1 - f0)).
template <class T>
struct SchlickWeights {
  T kd, ks, f0;
  static constexpr auto fields() {
    return std::array{Field{&SchlickWeights::kd, kDiffuseInfo}, Field{&SchlickWeights::ks, kSpecularInfo},
                      Field{&SchlickWeights::f0,
                            ParameterInfo{"f0", 0, 1, 0.04, 1, "", false,
                                          "Fresnel reflectance at normal incidence (of ks)", Role::f0}}};
  }
  constexpr std::array<T, 3> linear() const { return {kd, ks * f0, ks * (T(1) - f0)}; }
  // f0 of a lobe without weight is not identifiable; it is set to the default of the table.
  static constexpr SchlickWeights from_linear(const std::array<T, 3>& w) {
    const T ks = w[1] + w[2];
    return {w[0], ks, select(T(0) < ks, w[1] / ks, T(fields()[2].info.initial))};
  }
};

inline constexpr ParameterInfo kAlongInfo{
    "alpha_x", 1e-4, 1, 0.3, 1, "", true, "width of the slope distribution along the tangent", Role::width};
inline constexpr ParameterInfo kAcrossInfo{
    "alpha_y",         1e-4, 1, 0.3, 1, "", true, "width of the slope distribution across the tangent",
    Role::width_across};

template <class T>
struct Roughness {
  T alpha_x, alpha_y;
  static constexpr auto fields() {
    return std::array{Field{&Roughness::alpha_x, kAlongInfo}, Field{&Roughness::alpha_y, kAcrossInfo}};
  }
};

template <class T>
struct Exponent {
  T exponent;
  static constexpr auto fields() {
    return std::array{Field{&Exponent::exponent, ParameterInfo{"exponent", 0, 1e6, 20, 1e4, "", true,
                                                               "power of the cosine", Role::exponent}}};
  }
};

template <class T>
struct SlopeDeviation {
  T sigma;
  static constexpr auto fields() {
    return std::array{
        Field{&SlopeDeviation::sigma,
              ParameterInfo{"sigma", 0, kPi / 2, 0.3, kPi / 2, "rad", false,
                            "standard deviation of the slope angle of the microfacets", Role::slope}}};
  }
};

}  // namespace brdf
