// Are the integrals' error bounds honest? Random cases of each kind of integrand against a rule of much
// higher order, and that against a rule of another kind.
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
  std::size_t wrong;        // farther from the truth than the tolerance (unconverged: than its own bound)
  std::size_t unconverged;  // and said so
  double mean_evaluations;
  double worst;  // largest error over what was allowed
  std::string worst_case;
};

// Every set at 1e-4, 1e-6 and 1e-10, and "second_rule_SET": the truth of 100 of its cases against a rule of
// another kind, at 1e-7.
std::vector<IntegratorRow> check_integrators(std::uint64_t seed,
                                             const std::function<void(const IntegratorRow&)>& progress = {});

}  // namespace brdf::validate
