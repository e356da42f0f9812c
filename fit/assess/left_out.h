// Prediction of directions to which a model was not fitted.
#pragma once

#include <vector>

#include "fit/assess/result.h"
#include "fit/solve/sample_stream.h"

namespace brdf::fit {

// Predicts every group of rows (data.groups) by a fit to the rows of the other folds. `solutions` has one
// entry for each fold (fit/assess/refits.h). `loss_scale` is the scale of the loss, the same for all forms.
// A fold without a finite cost makes the value infinite.
LeftOut leave_out(const SampleStream& stream, std::vector<std::vector<double>> solutions, double loss_scale,
                  const FitOptions& options);

// Returns the mean loss of a surface that reflects nothing, the reference for the rounding error of a
// held-out value.
double black_loss(const FitData& data, const Model& model, const Residual& residual);

}  // namespace brdf::fit
