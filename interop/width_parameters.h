// Conversion between the parameters that set the width of a lobe in different formulas.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "brdf/names.h"
#include "interop/loss.h"

namespace brdf::interop {

// A parameter of a lobe. Several parameters may describe the same lobe: alpha of GGX and its perceptual
// roughness.
struct WidthParameter {
  std::string_view name;
  Reflectance form;        // of the catalogue, with the lobe
  std::string_view shape;  // its shape parameter, to which to_shape converts
  double (*to_shape)(double);
  double (*from_shape)(double);  // increasing
  std::string_view rule;         // "" if the parameter is the form's own

  // The range of the values, which follows from the range of the shape parameter.
  double low() const { return from_shape(shape_info().min); }
  double high() const { return from_shape(shape_info().max); }

 private:
  const ParameterInfo& shape_info() const {
    return info(form).shape[std::size_t(info(form).shape_index(shape))];
  }
};

// Returns all parameters, with those of the same form adjacent.
std::span<const WidthParameter> width_parameters();
// Returns the parameter with this name, or null if there is no such parameter.
const WidthParameter* find_width_parameter(std::string_view name);

// exact: both parameters describe the same formula. rule: a published rule between two formulas. fit: the
// other formula's nearest lobe, by the residual of fits (docs/fitting.md).
enum class Conversion { exact, rule, fit };

struct ConvertedWidth {
  double value = 0;
  Conversion kind = Conversion::exact;
  std::string rule;   // with its source
  double weight = 1;  // of the other formula's lobe, for a given lobe of weight 1; a fit may change it
  // What the other lobe loses against the given lobe, with f0 = 1 in formulas that have it. std::nullopt if
  // the conversion is exact.
  std::optional<Loss> loss{};
};

// Converts a value. Throws InputError if the value lies outside the parameter's range, or if the result
// lies outside the range of the other parameter.
ConvertedWidth convert_width(const WidthParameter& from, double value, const WidthParameter& to);

}  // namespace brdf::interop

namespace brdf {
template <>
inline constexpr std::array<std::string_view, 3> kNames<interop::Conversion>{"exact", "rule", "fit"};
}
