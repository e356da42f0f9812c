// Parses and applies the options of a command line that choose a material.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "brdf/material.h"
#include "io/material/material_json.h"

namespace brdf::io {

// One `name=value` or `name=value,value,...` of the command line.
struct Setting {
  std::string name;
  std::vector<double> values;
};

// Parses settings given to `option`, which is named in messages. Throws InputError.
std::vector<Setting> parse_settings(const std::vector<std::string>& texts, std::string_view option);

// The choice of a material on a command line: --form or --material, and --set.
struct MaterialChoice {
  std::string form;
  std::string material;               // path of a material's JSON
  std::vector<std::string> set;       // name=value
  std::optional<Material> made = {};  // used instead of `form` and `material`, at its defaults
};

// Returns the chosen material. A form has the default values of its table. The number of channels is that
// of the longest list of values: one channel is "fr", three are r, g, b. Throws InputError for an unknown
// form or parameter, a value out of range, a wrong count, or unless exactly one of form, material and made
// is given.
Material choose_material(const MaterialChoice& choice);
// Returns the chosen material with the statistics of its fit. They are null if the material is not from a
// fit or if --set has changed it.
MaterialFile choose_material_file(const MaterialChoice& choice);

// Applies each setting to all terms that have the parameter. The common name of the widths along and across
// the tangent ("alpha") sets both. tangent_phi is in degrees. Throws InputError if no term has the
// parameter or if a value is not valid.
void apply_settings(Material& material, const std::vector<Setting>& settings);

// Returns the parameter that a setting of this name sets, with its range and scale: a parameter of a term,
// the common name of the widths, or tangent_phi. Throws InputError with the list of known names.
ParameterInfo parameter_named(const Material& material, const std::string& name, const std::string& option);

// Returns the form of this name. Throws InputError with the list of known names.
Reflectance require_form(const std::string& name);

}  // namespace brdf::io
