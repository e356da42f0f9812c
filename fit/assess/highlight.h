// Detects a highlight that a fitted model lacks, if too few rows are affected to move a median or the share
// of the light, but more than chance explains.
#pragma once

#include <optional>

#include "fit/assess/assess.h"

namespace brdf::fit {

// A row counts if the measured value exceeds the model by 1.75 times the lower-quartile ratio of the rows,
// by a factor of 1.25, and by five times the noise. Three such rows are a misfit if they cluster around the
// mirror direction beyond chance, and if the model shows no such highlight. Chance means: random draws
// would put as many of them among the rows nearest to the mirror direction with a probability of 1e-3 at
// most (a bound of the hypergeometric tail; the best of all such cuts is counted as that many tries).
// Values below the model away from the mirror direction are tested in the same way. Each channel is judged
// separately; the finding describes the channel with the most rows.
Misfit judge_highlight(const FitData& data, const std::vector<std::vector<double>>& model,
                       std::optional<double> noise);

}  // namespace brdf::fit
