// Sentences about what the samples tell of the parameters, and what they do not.
#pragma once

#include "fit/assess/grounds.h"

namespace brdf::fit {

// What is not identified, and what would tell it.
std::string unidentified_finding(const std::vector<Reported>& all, const Grounds& on, const Uncertainty& u);

// Which parameters, and sums of weights, stand at the end of the range that was asked for.
void add_bound_findings(const std::vector<Reported>& all, const Grounds& on, Uncertainty& out);

// "2 rows decide ks and alpha (rows 41 and 42 of the table): their intervals suppose that these rows scatter
// as the others do"; empty where no parameter is decided by fewer than four.
std::string few_rows_finding(const std::vector<Reported>& all, const Grounds& on, const SampleStream& stream);

}  // namespace brdf::fit
