// The data by which the parameters of a solution are judged.
#pragma once

#include "fit/assess/assess.h"
#include "fit/assess/curvature.h"
#include "fit/assess/reported.h"

namespace brdf::fit {

struct Grounds {
  const Model& model;
  const Minimum& minimum;
  const Curvature& curvature;
  const RowMatrix* working;  // covariance under the working noise; null: not worth its passes
  double freedom;            // degrees of freedom of every variance
  bool exact;                // the noise of the samples is rounding alone
  bool few;                  // fewer than three rows for each parameter of a channel
  bool unturned;             // the sample was never turned, but a second width is fitted

  // Returns the standard error of a parameter with this gradient. `deciding` is the effective number of
  // values that decide the parameter. The fewer these values are, the less their own residuals reveal of
  // their noise, and the more the noise of all values is used instead.
  double error_of(const Eigen::VectorXd& gradient, double deciding) const;
};

// Returns how reliably the residuals of this many deciding values reveal their noise: 0 to 1.
double trust_in(double deciding);

// Sets the status, standard error and interval from the curvature. Identifiability is tested before the
// bounds.
void judge_parameter(Reported& r, const Grounds& on, Uncertainty& out);

// Returns a standard error on the solver's scale, or the standard error of the value if the parameter has
// no such scale.
double error_on_scale(const Reported& r, const Model& model, double error);
// Returns whether the parameter is at a bound.
bool at_bound(const Reported& r, const Minimum& m);
// Returns whether the parameter is a second width or the direction of the first width, which only a turn of
// the sample can reveal.
bool asks_for_turn(const Reported& r, const Model& model);

}  // namespace brdf::fit
