// A user's shader as a subject of checks.
#pragma once

#include <string>

#include "cli/options/shader_options.h"
#include "validate/search/subject.h"

namespace brdf::cli {

// Returns the facts about a finding that a shader's source provides.
validate::OutsideFacts facts_of(const LoadedShader& shader);
// Returns a shader's function as a subject with the name of its file.
validate::Subject subject_of(const LoadedShader& shader, const std::string& file);

}  // namespace brdf::cli
