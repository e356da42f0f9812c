// What the parameters of a solution are judged by.
#pragma once

#include "fit/assess/assess.h"
#include "fit/assess/curvature.h"
#include "fit/assess/reported.h"

namespace brdf::fit {

struct Grounds {
  const Model& model;
  const Minimum& minimum;
  const Curvature& curvature;
  const RowMatrix* working;  // covariance by the working noise; null: not worth its passes
  double freedom;            // degrees of freedom of every variance
  bool exact;                // the samples scatter by rounding alone
  bool few;                  // rows: fewer than three for each parameter of a channel
  bool unturned;             // the sample was never turned, and a second width is asked of it

  // The standard error of a parameter with this gradient, which so many values decide. Where these are few,
  // their own residuals say too little of their noise, and all values' say it.
  double error_of(const Eigen::VectorXd& gradient, double deciding) const;
};

// How far the residuals of so many values that decide a parameter tell their noise: 0 to 1.
double trust_in(double deciding);

// Status, standard error and interval by the curvature. Whether the samples tell the parameter is asked
// before whether it stands at a bound.
void judge_parameter(Reported& r, const Grounds& on, Uncertainty& out);

// A standard error on the solver's scale; that of the value where it has none.
double error_on_scale(const Reported& r, const Model& model, double error);
bool at_bound(const Reported& r, const Minimum& m);
// A second width, or the direction of the first: what only a turn of the sample shows.
bool asks_for_turn(const Reported& r, const Model& model);

}  // namespace brdf::fit
