// Why a candidate was chosen or not, and what a scene does not need, in sentences.
#pragma once

#include "trade/recommend/recommend.h"

namespace brdf::trade {

// The error that the tolerance is about.
double judged(const Candidate& candidate, Judge judge);

// Fills in every candidate's reason, what is unneeded, and the chosen form's known violations. Candidates are
// sorted and chosen already.
void explain(Recommendation& r, const RecommendOptions& options);

}  // namespace brdf::trade
