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

// Parses settings as given to `option` (named in messages). Throws InputError.
std::vector<Setting> parse_settings(const std::vector<std::string>& texts, std::string_view option);

// How a verb is told about a material: --form or --material, and --set.
struct MaterialChoice {
  std::string form;
  std::string material;               // path of a material's JSON
  std::vector<std::string> set;       // name=value
  std::optional<Material> made = {};  // instead of those: what reflects, at its defaults
};

// The material chosen. Of a form: the table's defaults with one channel, "fr", or as many as the longest list
// of values has (three are r, g, b). Throws InputError on an unknown form or parameter, a value out of range,
// a wrong count, or when not exactly one of form and material is given.
Material choose_material(const MaterialChoice& choice);
// The same with the statistics of the fit it came from: null where it is of no fit, or --set has changed it.
MaterialFile choose_material_file(const MaterialChoice& choice);

// Applies settings to every term that has the parameter; what the widths along and across are called together
// ("alpha") sets both, tangent_phi is in degrees.
void apply_settings(Material& material, const std::vector<Setting>& settings);

// What a setting of that name sets, with its range and scale: a term's parameter, the widths' common name,
// tangent_phi. Throws InputError that lists the known ones.
ParameterInfo parameter_named(const Material& material, const std::string& name, const std::string& option);

// The form of that name. Throws InputError that lists the known ones.
Reflectance require_form(const std::string& name);

}  // namespace brdf::io
