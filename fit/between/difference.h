// The difference between the fits of two tables, compared with the uncertainty of both.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fit/between/common_values.h"
#include "fit/between/quantities.h"
#include "fit/between/tables.h"

namespace brdf::fit {

// The difference of one parameter, first table minus second, on the scale of the comparison: relative if the
// parameter is logarithmic.
struct ParameterDifference {
  std::string name;
  bool logarithmic = true;
  double first = 0, second = 0;            // in the parameter's own unit
  double difference = 0, uncertainty = 0;  // standard uncertainty of the difference
  bool beyond = false;  // the difference is significant, at a level of 5 % over all parameters
};

// The difference of the logarithms of the fitted f at a pair of directions.
struct DirectionDifference {
  AskedDirections at;
  std::string channel;
  double difference = 0, uncertainty = 0;
  bool beyond = false;  // outside the band that holds all directions together with 95 %
};

// Whether the two surfaces are the same.
enum class Sameness {
  no_difference,  // within the budgets
  different,
  undecided
};

struct Difference {
  FittedTables fits;
  Sameness sameness = Sameness::undecided;
  std::string obstacle;  // the reason why the parameters cannot be compared; empty if they can

  // The remaining members are set if there is no obstacle. The uncertainties contain the budgets if there are
  // budgets, otherwise the scatter alone.
  std::vector<ParameterDifference> parameters;
  Matrix covariance;                            // of the differences
  double statistic = 0;                         // W = d' C^-1 d, with the sum C of both covariances
  double freedom = 0;                           // degrees of freedom of C along d
  double probability = 1;                       // of a statistic at least as large for equal surfaces
  std::vector<DirectionDifference> directions;  // in the plane of incidence
  double band = 0;                     // half width of the band of the directions, in standard uncertainties
  std::optional<CommonValues> common;  // std::nullopt: not compared
  // The reason why the equal parameters do not show equal surfaces; empty if they do.
  std::string doubt;

  // Returns the names of the parameters that differ. If the statistic is significant but no single parameter
  // is, returns the parameter whose change alone leaves the least. Empty if the values alone differ.
  std::vector<std::string> differing() const;
};

// The residuals over the noise, above which the parameters of a form do not stand for a surface.
inline constexpr double kGrossMisfit = 10;

// Compares the fits of two tables, and the values that both tables hold. Their errors are taken as
// independent. Equal surfaces are called different in at most about 5 % of pairs if the budgets are
// complete and the form describes both tables alike. A form sees the differences that its parameters
// describe: if its residuals are more than kGrossMisfit times the noise of a table, equal parameters show
// equal surfaces only together with values at the same directions.
Difference difference_of(FittedTables fits, const std::vector<TableToFit>& tables);

// A vector of changes of the parameters, and its size that leaves the least of the difference.
struct Remainder {
  double size = 0;
  double statistic = 0;    // W of the difference without the change
  double probability = 0;  // of a statistic at least as large, for one dimension less
};
// Returns the remainder of a difference if `change` times a size explains the rest. `freedom`: degrees of
// freedom of the covariance.
Remainder remainder_without(const std::vector<double>& difference, const Matrix& covariance,
                            const std::vector<double>& change, double freedom);
// Returns d' C^-1 d; std::nullopt if C is not positive definite.
std::optional<double> quadratic_form(const std::vector<double>& difference, const Matrix& covariance);

}  // namespace brdf::fit
