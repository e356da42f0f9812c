// Errors of a model's values relative to the measured ones, in figures for readers.
#pragma once

#include <vector>

#include "fit/assess/result.h"
#include "fit/model/data.h"

namespace brdf::fit {

// Computes the relative errors of the model's values, [channel][row], over the rows of `range` with
// measured values above 0.
RelativeErrors relative_errors(const FitData& data, const std::vector<std::vector<double>>& model,
                               const RowRange& range);

// Returns the root mean square of (model - value)/value over all rows with measured values above 0.
double rms_error(const FitData& data, const std::vector<std::vector<double>>& model);

}  // namespace brdf::fit
