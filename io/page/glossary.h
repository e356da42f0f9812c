// The glossary of the reports: terms and their meanings, for readers who do not write programs.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "brdf/reflectance.h"

namespace brdf::io {

struct GlossaryTerm {
  std::string term, meaning;
  bool in_text = false;  // a symbol: also explained at its first occurrence in running text
};

// Returns the terms: quantities and statistics, and the parameters of all forms of the catalogue, as
// described in the tables of the forms.
const std::vector<GlossaryTerm>& glossary();

// Returns the term, or null if the glossary does not contain `word`.
const GlossaryTerm* glossary_term(std::string_view word);

// Returns the plain name of a parameter of a form, derived from its role: "surface roughness along".
// `along_is_all`: both axes have the same value, so "along" is omitted.
std::string plain_name(const ReflectanceInfo& form, const ParameterInfo& parameter,
                       bool along_is_all = false);

}  // namespace brdf::io
