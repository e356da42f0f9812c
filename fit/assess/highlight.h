// A highlight that a fitted model lacks: too few rows to move a median or the light's share, but no chance
// either.
#pragma once

#include <optional>

#include "fit/assess/assess.h"

namespace brdf::fit {

// Rows count where the measured value stands above the model by 1.75 times what the lower quarter of the rows
// does, by a quarter at all, and by five times the noise. Three of them are a misfit where they lie around
// the mirror direction beyond chance: more of them among the rows nearest to it than one draw in a thousand
// would put there (a bound of the hypergeometric tail, the best of all such cuts counted as that many tries),
// and where the model shows no such highlight. The same is asked of values below the model away from the
// mirror direction. Judged per channel; the finding is of the channel with the most rows.
Misfit judge_highlight(const FitData& data, const std::vector<std::vector<double>>& model,
                       std::optional<double> noise);

}  // namespace brdf::fit
