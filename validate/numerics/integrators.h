// Checks whether the integrals' error bounds are honest. Random cases of each kind of integrand are
// compared with a rule of much higher order, and that rule is compared with a rule of another kind.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "validate/numerics/integral_cases.h"

namespace brdf::validate {

struct IntegratorRow {
  std::string set;
  double tolerance;  // relative
  std::size_t cases;
  std::size_t wrong;        // farther from the truth than the tolerance (unconverged: than their bound)
  std::size_t unconverged;  // results that reported no convergence
  double mean_evaluations;
  double worst;  // largest error over the allowed error
  std::string worst_case;
};

// Measures every set at the tolerances 1e-4, 1e-6 and 1e-10, and returns one row for each. The further rows
// "second_rule_SET" compare the truth of 100 cases of the set with a rule of another kind, at 1e-7.
std::vector<IntegratorRow> check_integrators(std::uint64_t seed,
                                             const std::function<void(const IntegratorRow&)>& progress = {});

}  // namespace brdf::validate
