// Propagation of the covariance of the solver's parameters to quantities that depend on them.
#pragma once

#include <span>
#include <vector>

#include "fit/algebra/eigen_view.h"
#include "fit/assess/reported.h"
#include "fit/assess/result.h"
#include "fit/solve/sample_stream.h"

namespace brdf::fit {

// Above this many rows no value has a leverage that justifies a second pass.
inline constexpr std::size_t kManyRows = 100000;

// Covariance of the solver's parameters, 0 for held parameters. `inverse` is the inverse of the normal
// matrix.
struct SlotCovariance {
  const RowMatrix &matrix, &inverse;
};

// Returns the gradient of a reported parameter by all of the solver's parameters.
Eigen::VectorXd gradient_vector(const Reported& r, Eigen::Index n);

// Returns the covariance of the parameters that are neither held nor at a bound. Parameters that are set
// together count as one. The components are the principal components of the correlations; the degrees of
// freedom of each component are counted in the same way as for a parameter.
ParameterCovariance parameter_covariance(const SampleStream& stream, std::span<const double> p,
                                         const std::vector<Reported>& all, const SlotCovariance& c,
                                         double freedom);

// Returns the relative standard error that 95 % of the model's values, and 95 % of the light, do not
// exceed.
double prediction_error(const SampleStream& stream, std::span<const double> p, const RowMatrix& covariance);
// Returns whether that prediction error is at most `error`.
bool predicts_within(double error, const SampleStream& stream, std::span<const double> p,
                     const RowMatrix& covariance);

}  // namespace brdf::fit
