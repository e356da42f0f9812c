// The uncertainty budget of an instrument in the results of a fit: for every row, for every parameter, and
// in the covariance from which all other intervals follow.
#pragma once

#include <optional>
#include <vector>

#include "fit/assess/assess.h"
#include "fit/assess/curvature.h"
#include "fit/assess/reported.h"

namespace brdf::fit {

// The name of the scatter of the rows among the sources of a budget.
inline constexpr const char* kScatterSource = "scatter of the rows";

// Computes the relative errors that the sources of the budget of stream.data() cause in the values of the
// model at the solver's parameters p. The budget must be there. First order: derivatives by the polar angles
// are central differences of 1e-4 rad of the averages over the detector's field. An instrument that divides
// by the nominal cosine of the viewing angle reads f(theta + e) cos(theta_o + e_o)/cos(theta_o), so that its
// sensitivity to theta_o is d ln f/d theta_o - tan theta_o.
RowBudget row_budget(const SampleStream& stream, std::span<const double> p);

// The covariance of the solver's parameters with a budget.
struct InstrumentCovariance {
  RowBudget rows;
  std::vector<SourceCovariance> sources;
  // The part that is independent from row to row: that of the sources, or of the scatter of the residuals if
  // the latter is larger beyond chance. `total` adds the sources that rows share.
  RowMatrix rowwise, total;
  // The covariance from the scatter of the rows, and the part of it that is left if the most likely errors
  // that rows share are taken out of the residuals.
  RowMatrix scatter, left;
  double freedom = 0;  // of the scatter
};

// Computes the covariance with the budget of stream.data(), which must be there. An error that rows share
// moves them together: its effect on a parameter is not divided by the root of their number. `inverse`: of
// the normal matrix. `scatter`: the covariance from the scatter of the rows; `freedom`: its degrees of
// freedom.
InstrumentCovariance instrument_covariance(const SampleStream& stream, std::span<const double> p,
                                           const RowMatrix& inverse, const RowMatrix& scatter,
                                           double freedom);

// Adds the budget to the estimate of a parameter: its standard error becomes the combined standard
// uncertainty, and its interval becomes that of with_budget(). At a bound only the interval changes.
void add_budget(const InstrumentCovariance& instrument, const Model& model, Reported& r);

// Returns the interval with its half widths multiplied by `kept` and widened in quadrature by 1.96 times the
// standard uncertainty `extra`, on the scale on which the interval of the parameter is symmetric.
Extent with_budget(const Reported& r, const Model& model, Extent interval, double kept, double extra);

}  // namespace brdf::fit
