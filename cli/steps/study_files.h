// The terminal output of a study.
#pragma once

#include <string>
#include <vector>

#include "cli/verb.h"
#include "study/study.h"

namespace brdf::cli {

// Prints a line for each sample, or JSON if `json` is true, and on stderr the reason for each sample without
// a study.
Exit print_study(const std::vector<study::Row>& rows, const std::filesystem::path& folder, bool json);

}  // namespace brdf::cli
