// Compares a subject with a form of the catalogue and reports where, and by how much, the two differ.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/material/expression.h"
#include "validate/form/checks.h"

namespace brdf::validate {

// A parameter of the form that is computed from the subject's parameters.
struct MappedParameter {
  std::string name;
  ParameterInfo info;                     // the form's parameter, with its range
  std::optional<io::Expression> formula;  // empty: the subject's parameter of the same name
};

struct Against {
  Reflectance form;
  std::vector<MappedParameter> mapped;
  std::vector<std::pair<std::string, double>> defaults;  // values of the form's other parameters
};

// Parses the mapping from the subject's parameters to the parameters of `form`. `maps` holds entries such
// as "alpha=roughness*roughness". Parameters of the same name are equated; the remaining ones take the
// form's defaults. Throws InputError if a name is unknown to the form or to the subject, and if every
// choice of the subject's parameters puts some parameter outside the form's range.
Against parse_against(const Subject& subject, const std::string& form, const std::vector<std::string>& maps);

// Finds the largest relative difference over pairs of directions and over the subject's parameters that lie
// within the form's ranges. The difference is relative to the larger value, or to 0.01/sr if both values
// are smaller. The finding names the place of the largest difference and the parameter ranges that were
// compared.
Finding check_against(const Subject& subject, const Against& against, const CheckOptions& options);

}  // namespace brdf::validate
