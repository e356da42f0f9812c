// A subject beside a form of the catalogue: where and by how much they differ.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "io/material/expression.h"
#include "validate/form/checks.h"

namespace brdf::validate {

// A parameter of the form that the subject's parameters give.
struct MappedParameter {
  std::string name;
  ParameterInfo info;                     // of the form: its range
  std::optional<io::Expression> formula;  // none: the subject's parameter of the same name
};

struct Against {
  Reflectance form;
  std::vector<MappedParameter> mapped;
  std::vector<std::pair<std::string, double>> defaults;  // of the form's other parameters
};

// `maps`: "alpha=roughness*roughness"; parameters of the same name are the same, others have the form's
// defaults. Throws InputError where a name is neither's, and where for all parameters of the subject
// something lies outside the form's ranges.
Against parse_against(const Subject& subject, const std::string& form, const std::vector<std::string>& maps);

// The largest relative difference over pairs of directions (below 0.01/sr relative to that) and those of the
// subject's parameters that the form has values for; where; and what was compared.
Finding check_against(const Subject& subject, const Against& against, const CheckOptions& options);

}  // namespace brdf::validate
