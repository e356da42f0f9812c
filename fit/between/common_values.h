// Measured values of two tables at the same directions, compared without a form.
#pragma once

#include <cstddef>
#include <optional>

#include "fit/between/tables.h"

namespace brdf::fit {

// The values that both tables hold, and the number of values that differ beyond the budgets and the noise
// of both.
struct CommonValues {
  std::size_t count = 0, beyond = 0;
  // The value that differs most in units of its uncertainty: its channel, its directions in degrees, and the
  // logarithm of the second value over the first one with its standard uncertainty.
  std::size_t channel = 0;
  double theta_i = 0, phi_i = 0, theta_o = 0, phi_o = 0;
  double difference = 0, uncertainty = 0;

  // Returns whether the surfaces differ: so many values are beyond that an outlier, or the curvature of a
  // narrow highlight, does not explain them.
  bool differ() const { return double(beyond) >= kShare * double(count) && beyond > 1; }

  static constexpr double kShare = 0.05;
};

// Compares the values of rows with the same four angles to 1e-6 degrees. The standard uncertainty of a
// difference consists of all sources of both budgets, to first order about the fits, and of the noise of
// both tables. A value is beyond if its difference is significant at 0.1 % over all values (Bonferroni).
// Returns std::nullopt if a table has no budget, if the noise of a table is not known, or if the tables
// have fewer than 30 values in common.
std::optional<CommonValues> common_values(const std::vector<FittedTable>& fits,
                                          const std::vector<TableToFit>& tables);

}  // namespace brdf::fit
