// Ranking of the models.
#pragma once

#include "fit/assess/result.h"

namespace brdf::fit {

// A model is never as good as the best if its held-out value exceeds this factor times the least one, even
// if too few groups are left out to distinguish the two.
inline constexpr double kAsGood = 1.1;

// Sorts the ranking, best first, and sets `recommended`. Returns the previous position of each entry.
//
// The order is by the held-out value, or by the median error if held-out values were not requested. Equal
// values (three digits) are ordered by whether the forms are usable, then by the number of parameters.
// Forms without a finite cost come last. A usable form that ranks below a misfit by the share of its light
// becomes a misfit too, because the verdicts must not contradict the order.
//
// `recommended` is the usable form with the fewest parameters whose held-out value is at most a tenth above
// the value of the first form and that the paired test does not find worse. If this form breaks energy
// conservation, the first usable form is recommended.
std::vector<std::size_t> rank(FitResult& result);

}  // namespace brdf::fit
