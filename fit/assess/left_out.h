// What a model predicts of directions that it was not fitted to.
#pragma once

#include <span>

#include "fit/assess/result.h"
#include "fit/solve/sample_stream.h"

namespace brdf::fit {

// Every group of rows (data.groups) is predicted by a fit of the other folds' rows: all of them, however many there
// are. Each fold is solved from the solution on all rows in a few iterations. `loss_scale`: what the loss is
// judged with, the same for all forms; the refits use the stream's own. None where there are fewer than two folds.
// A fold without a finite cost makes the value infinite.
std::optional<LeftOut> leave_out(const SampleStream& stream, std::span<const double> solution,
                                 double loss_scale, const FitOptions& options);

// Mean loss of a surface that reflects nothing: what a left-out value's rounding is measured by.
double black_loss(const FitData& data, const Model& model, const Residual& residual);

}  // namespace brdf::fit
