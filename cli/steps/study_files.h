#pragma once

#include <string>
#include <vector>

#include "cli/verb.h"
#include "study/study.h"

namespace brdf::cli {

// Prints a line for each sample, or `json`, and on stderr why samples have no study.
Exit print_study(const std::vector<study::Row>& rows, const std::filesystem::path& folder, bool json);

}  // namespace brdf::cli
