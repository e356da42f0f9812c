// From the covariance of the solver's parameters to that of what is made of them.
#pragma once

#include <span>
#include <vector>

#include "fit/algebra/eigen_view.h"
#include "fit/assess/reported.h"
#include "fit/assess/result.h"
#include "fit/solve/sample_stream.h"

namespace brdf::fit {

// Above this many rows no value has a leverage worth a second pass.
inline constexpr std::size_t kManyRows = 100000;

// Of the solver's parameters, 0 for those held; `inverse`: of the normal matrix.
struct SlotCovariance {
  const RowMatrix &matrix, &inverse;
};

// The gradient of a reported parameter by all of the solver's.
Eigen::VectorXd gradient_vector(const Reported& r, Eigen::Index n);

// Of what is neither held nor at a bound; parameters that are set together are one. The components are the
// principal ones of the correlations; each one's degrees of freedom are counted as a parameter's are.
ParameterCovariance parameter_covariance(const SampleStream& stream, std::span<const double> p,
                                         const std::vector<Reported>& all, const SlotCovariance& c,
                                         double freedom);

// Relative standard error that 95 % of the model's values keep to, and 95 % of the light.
double prediction_error(const SampleStream& stream, std::span<const double> p, const RowMatrix& covariance);
// Whether that is at most `error`.
bool predicts_within(double error, const SampleStream& stream, std::span<const double> p,
                     const RowMatrix& covariance);

}  // namespace brdf::fit
