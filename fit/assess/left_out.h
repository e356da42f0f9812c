// What a model predicts of directions that it was not fitted to.
#pragma once

#include <vector>

#include "fit/assess/result.h"
#include "fit/solve/sample_stream.h"

namespace brdf::fit {

// Every group of rows (data.groups) is predicted by a fit of the other folds' rows: `solutions`, one for each
// fold (fit/assess/refits.h). `loss_scale`: what the loss is judged with, the same for all forms. A fold
// without a finite cost makes the value infinite.
LeftOut leave_out(const SampleStream& stream, std::vector<std::vector<double>> solutions, double loss_scale,
                  const FitOptions& options);

// Mean loss of a surface that reflects nothing: what a left-out value's rounding is measured by.
double black_loss(const FitData& data, const Model& model, const Residual& residual);

}  // namespace brdf::fit
