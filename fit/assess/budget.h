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
  // the latter is larger. `total` adds the sources that rows share.
  RowMatrix rowwise, total;
};

// Computes the covariance with the budget of stream.data(), which must be there. An error that rows share
// moves them together: its effect on a parameter is not divided by the root of their number. `inverse`: of
// the normal matrix. `scatter`: the covariance from the scatter of the rows.
InstrumentCovariance instrument_covariance(const SampleStream& stream, std::span<const double> p,
                                           const RowMatrix& inverse, const RowMatrix& scatter);

// Adds the budget to the estimate of a parameter: its standard error becomes the combined standard
// uncertainty, and its interval is widened in quadrature by 1.96 times the additional standard uncertainty, on
// the scale on which the interval is symmetric.
void add_budget(const InstrumentCovariance& instrument, const Model& model, Reported& r);

// Returns the interval widened by the standard uncertainty that the sources add to the scatter of the rows.
// Returns the interval itself if the estimate has no budget.
Extent with_budget(const Reported& r, const Model& model, Extent interval, const Combined& combined);

}  // namespace brdf::fit
