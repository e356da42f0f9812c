#pragma once

#include <string>
#include <vector>

#include "brdf/reflectance.h"
#include "cli/verb.h"

namespace brdf::cli {

// `brdf render --parity`: the deferred picture against Embree for the named forms, or all, and for others.
Exit run_parity(const std::vector<std::string>& names, bool all, const std::vector<Reflectance>& others,
                bool json);

}  // namespace brdf::cli
