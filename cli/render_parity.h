#pragma once

#include <string>
#include <vector>

#include "cli/verbs.h"

namespace brdf::cli {

// `brdf render --parity`: the deferred picture against Embree for the named forms, or all.
Exit run_parity(const std::vector<std::string>& names, bool all, bool json);

}  // namespace brdf::cli
