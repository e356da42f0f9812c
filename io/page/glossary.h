// The words of the reports, each with what it means, for readers who write no programs.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "brdf/reflectance.h"

namespace brdf::io {

struct GlossaryTerm {
  std::string term, meaning;
  bool in_text = false;  // a symbol: explained wherever it stands first, not only in headers
};

// Quantities and statistics, and the parameters of every form of the catalogue by the forms' own tables.
const std::vector<GlossaryTerm>& glossary();

// Null where the word is not in it.
const GlossaryTerm* glossary_term(std::string_view word);

// What a parameter of a form is in plain words, from its role: "surface roughness along". `along_is_all`:
// both axes have one value.
std::string plain_name(const ReflectanceInfo& form, const ParameterInfo& parameter,
                       bool along_is_all = false);

}  // namespace brdf::io
