// The curvature of the cost at a minimum, and the covariance that the samples' noise gives the solver's
// parameters there.
#pragma once

#include <Eigen/Dense>

#include "fit/assess/propagation.h"
#include "fit/solve/minima.h"
#include "fit/solve/sample_stream.h"

namespace brdf::fit {

struct KnownMatrices;  // fit/assess/assess.h

// Every parameter that has an effect on the samples is in these matrices, whether a bound holds it or not: a
// partner of one at its bound is not better known because the minimum happens to stand there.
struct Curvature {
  RowMatrix bread;        // the normal matrix, with the curvature of the loss
  RowMatrix inverse;      // of the normal matrix, of all slots; 0 for those without effect
  RowMatrix covariance;   // heteroscedasticity-consistent: rows independent, channels of a row not
  RowMatrix null_space;   // columns, on the scaled axes: directions that change nothing in the samples
  RowMatrix weakest;      // the least certain direction, on the scaled axes
  Eigen::VectorXd scale;  // of the axes: 1/sqrt(diagonal); 0 for slots without effect
  double condition = 1;

  // Whether a function of the parameters with this gradient moves along a direction that changes nothing in
  // the samples.
  bool without_effect(const Eigen::VectorXd& gradient) const;
};

Curvature curvature(const SampleStream& stream, const Minimum& m, const KnownMatrices* known = nullptr);

// The covariance of the parameters where the noise of a value is in proportion to the root of its square and
// the square of a floor, the same share for all values, estimated from all of them (generalised least
// squares' working model; Carroll and Ruppert 1988, chapter 3). Few values with small residuals cannot make
// it small. The floor is the one of a few that makes the residuals the likeliest. Residuals in units of a
// stated sigma are taken as equally noisy.
struct WorkingNoise {
  RowMatrix covariance;
  double relative = 0;     // standard deviation over that root
  double floor = 0;        // 1/sr
  double correlation = 0;  // of the channels of a row
};
WorkingNoise working_noise(const SampleStream& stream, const Minimum& m, const Curvature& c);

}  // namespace brdf::fit
