// Explains in sentences the choice of a candidate, and lists features that a scene does not need.
#pragma once

#include "trade/recommend/recommend.h"

namespace brdf::trade {

// Returns the error to which the tolerance applies.
double judged(const Candidate& candidate, Judge judge);

// Fills in the reason of every candidate, the unneeded features, and the known violations of the chosen
// form. Candidates must be sorted and the choice must be made already.
void explain(Recommendation& r, const RecommendOptions& options);

}  // namespace brdf::trade
