// Sentences about what the samples tell of the parameters, and what they do not.
#pragma once

#include "fit/assess/grounds.h"

namespace brdf::fit {

// What is not identified, and what would tell it.
std::string unidentified_finding(const std::vector<Reported>& all, const Grounds& on, const Uncertainty& u);

// Which parameters, and sums of weights, stand at the end of the range that was asked for.
void add_bound_findings(const std::vector<Reported>& all, const Grounds& on, Uncertainty& out);

}  // namespace brdf::fit
