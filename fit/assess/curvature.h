// The curvature of the cost at a minimum, and the covariance of the solver's parameters that follows from
// the noise of the samples.
#pragma once

#include <Eigen/Dense>

#include "fit/assess/propagation.h"
#include "fit/solve/minima.h"
#include "fit/solve/sample_stream.h"

namespace brdf::fit {

struct KnownMatrices;  // in fit/assess/assess.h

// The matrices contain every parameter that affects the samples, whether or not a bound holds the
// parameter. A parameter that is correlated with one at its bound is not better known because the minimum
// happens to lie on the bound.
struct Curvature {
  RowMatrix bread;        // the normal matrix, with the curvature of the loss
  RowMatrix inverse;      // inverse of the normal matrix, over all slots; 0 for slots without effect
  RowMatrix covariance;   // heteroscedasticity-consistent: rows are independent, channels of a row are not
  RowMatrix null_space;   // columns, on the scaled axes: directions that change nothing in the samples
  RowMatrix weakest;      // the least certain direction, on the scaled axes
  Eigen::VectorXd scale;  // of the axes: 1/sqrt(diagonal); 0 for slots without effect
  double condition = 1;

  // Returns whether a function of the parameters with this gradient changes along a direction that has no
  // effect on the samples.
  bool without_effect(const Eigen::VectorXd& gradient) const;
};

// Computes the curvature at the minimum `m`. `known` holds the matrices at this point if they are already
// known, otherwise null.
Curvature curvature(const SampleStream& stream, const Minimum& m, const KnownMatrices* known = nullptr);

// The covariance of the parameters under a working model of the noise (generalised least squares; Carroll
// and Ruppert 1988, chapter 3). The noise of a value is proportional to the root of the sum of its square
// and the square of a floor. The factor is the same for all values and is estimated from all of them, so a
// few values with small residuals cannot make the covariance small. The floor is the most likely of a few
// candidates, given the residuals. Residuals in units of a stated sigma are assumed to be equally noisy.
struct WorkingNoise {
  RowMatrix covariance;
  double relative = 0;     // standard deviation divided by that root
  double floor = 0;        // 1/sr
  double correlation = 0;  // between the channels of a row
};
// Estimates the working noise at the minimum `m`, where the curvature of the cost is `c`.
WorkingNoise working_noise(const SampleStream& stream, const Minimum& m, const Curvature& c);

}  // namespace brdf::fit
