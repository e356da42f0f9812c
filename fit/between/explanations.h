// Errors of an instrument that would explain the difference between two tables of one surface.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "brdf/names.h"
#include "fit/between/difference.h"

namespace brdf::fit {

enum class Cause { scale, zero_theta_i, zero_theta_o, aperture };

}  // namespace brdf::fit

namespace brdf {

template <>
inline constexpr std::array<std::string_view, 4> kNames<fit::Cause>{"scale", "zero_theta_i", "zero_theta_o",
                                                                    "aperture"};

}  // namespace brdf

namespace brdf::fit {

// One error of one instrument, with the size that leaves the least of the difference.
struct Explanation {
  Cause cause = Cause::scale;
  std::string table;  // the table that has the error
  // scale: relative excess of the values; zero errors: true angle minus stated angle, degrees; aperture: full
  // width of the detector's field, degrees.
  double size = 0;
  double statistic = 0;    // W of the difference without the error
  double probability = 0;  // of a statistic at least as large for equal surfaces, for one dimension less
  // The standard uncertainty of this error according to the budgets of both tables, in the unit of the size.
  // 0 without budgets, for an aperture, and if the budgets do not have the error.
  double stated = 0;
  bool found = false;     // the size is within the limits, and it leaves the least or explains the difference
  bool explains = false;  // the error alone is enough: the rest is not significant at 5 %
};

// The limits within which sizes are sought.
inline constexpr double kLargestScale = 0.5, kLargestZeroError = 5, kLargestAperture = 20;

// Returns for each cause the size that explains most of the difference, found by fits to tables that are
// corrected for the error. A scale or a zero error is looked for in the second table (the same error in the
// first table has about the opposite size). An aperture is looked for in both tables, and the better one is
// returned; a table that is fitted with an aperture is left out. `difference` has no obstacle.
std::vector<Explanation> explanations_of(const Difference& difference, const std::vector<TableToFit>& tables);

// A difference with the errors that would explain it; no explanations if there is an obstacle or no
// difference beyond the uncertainties.
struct Comparison {
  Difference difference;
  std::vector<Explanation> explanations;
};
// Fits both tables and compares them. The arguments are as in fit_tables().
Comparison compare_tables(std::vector<TableToFit> tables, std::vector<std::vector<Reflectance>> models,
                          const Progress& progress = {});

}  // namespace brdf::fit
