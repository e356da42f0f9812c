// How far a model's values are from the measured ones, in figures for people.
#pragma once

#include <vector>

#include "fit/assess/result.h"
#include "fit/model/data.h"

namespace brdf::fit {

// Of the model's values [channel][row]; over the measured values above 0 of these rows.
RelativeErrors relative_errors(const FitData& data, const std::vector<std::vector<double>>& model,
                               const RowRange& range);

}  // namespace brdf::fit
