// Options of the checks: how thoroughly a search looks, and for how long.
#pragma once

#include <cstdint>

#include "validate/search/budget.h"

namespace brdf::validate {

enum class Effort { quick, full };

struct CheckOptions {
  Effort effort = Effort::quick;
  double max_theta = 89.5;  // degrees, of the energy check's fixed direction
  std::uint64_t seed = 1;
  double seconds = 0;        // of each check's searches; 0: no limit
  Budget* budget = nullptr;  // of the running check; set by run_checks()
};

}  // namespace brdf::validate
