// Residuals of a block of values, with their derivatives by the model, and robust losses.
#pragma once

#include <cstddef>

#include "fit/model/options.h"

namespace brdf::fit {

// A loss rho(s) of the squared residual: concave, rho(0) = 0, slope 1 at 0.
struct LossFunction {
  enum class Kind { none, huber, cauchy, cube_root } kind = Kind::none;
  double scale = 1;  // in units of the residual
};

struct Residual {
  Metric metric = Metric::log;
  LossFunction loss;
  // Linearised at the measurement, r'(g) (f - g): linear in the weights, and close to the metric near the
  // data. Used to compute starting weights.
  bool linearised = false;
};

// One channel of a block of rows: model, measurement, cosines, square root of the weight (null: 1), sigma
// (null: not used).
struct ResidualInputs {
  const double *f, *g, *cos_i, *cos_o, *weight, *sigma;
  std::size_t rows;
  const double* value_slope = nullptr;  // result of slopes_at_values(), if already computed
};

// Computes the slopes of a logarithmic residual at the measurements, without weight and sigma.
void slopes_at_values(const Residual& residual, const ResidualInputs& block, double* out);

// Computes r[j] and dr/df[j], weights included. With sigma, the residual is in units of its standard
// deviation.
void residuals(const Residual& residual, const ResidualInputs& block, double* r, double* derivative);

// Applies a loss. rho[j] = rho(r^2); `root_slope` = sqrt(rho'(r^2)), the factor for residual and
// derivative; `curvature` = d^2 (rho/2)/dr^2, for use in a covariance.
void apply_loss(const LossFunction& loss, std::size_t rows, const double* r, double* rho, double* root_slope,
                double* curvature);

}  // namespace brdf::fit
