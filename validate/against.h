// A subject beside a form of the catalogue: where and by how much they differ.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "io/expression.h"
#include "validate/checks.h"

namespace brdf::validate {

struct Against {
  Reflectance form;
  // The form's parameters from the subject's; those of the same name are the same, others have the form's defaults.
  std::vector<std::pair<std::string, io::Expression>> map;
};

// `maps`: "alpha=roughness*roughness". Throws InputError where a name is neither's.
Against parse_against(const Subject& subject, const std::string& form, const std::vector<std::string>& maps);

// The largest relative difference over the subject's parameters and pairs of directions (below 0.01/sr relative to that), and where.
Finding check_against(const Subject& subject, const Against& against, const CheckOptions& options);

}  // namespace brdf::validate
