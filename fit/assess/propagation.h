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
  bool pooled;  // the residuals of all values state it, and not those of the deciding values
};

// The effect of one source of a budget on the solver's parameters.
struct SourceCovariance {
  std::string source;
  bool is_shared = false;  // one error moves several rows
  RowMatrix covariance;
};

// Returns a covariance, raised in the directions in which the covariance `other` is more than `limit` times
// as large, by the share `trust` of the excess.
RowMatrix larger_of(const RowMatrix& covariance, const RowMatrix& other, double trust, double limit = 1);

// Returns a covariance, multiplied in each direction by the share of the covariance `before` that is left in
// the covariance `after`, which is at most 1. In these directions both are uncorrelated.
RowMatrix shrunk(const RowMatrix& covariance, const RowMatrix& before, const RowMatrix& after);

// Returns the gradient of a reported parameter by all of the solver's parameters.
Eigen::VectorXd gradient_vector(const Reported& r, Eigen::Index n);

// Returns the covariance of the parameters that are neither held nor at a bound. Parameters that are set
// together count as one. The components are the principal components of the correlations. A component has
// `freedom` degrees of freedom if the covariance is pooled, otherwise Satterthwaite's (1946) of the values
// that decide the component. The sources that rows share follow as components of their own.
ParameterCovariance parameter_covariance(const SampleStream& stream, std::span<const double> p,
                                         const std::vector<Reported>& all, const SlotCovariance& c,
                                         double freedom, std::span<const SourceCovariance> sources = {});

// Returns the relative standard error that 95 % of the model's values, and 95 % of the light, do not
// exceed.
double prediction_error(const SampleStream& stream, std::span<const double> p, const RowMatrix& covariance);
// Returns whether that prediction error is at most `error`.
bool predicts_within(double error, const SampleStream& stream, std::span<const double> p,
                     const RowMatrix& covariance);

}  // namespace brdf::fit
