// Sentences on which parameters the samples identify and which they do not.
#pragma once

#include "fit/assess/grounds.h"

namespace brdf::fit {

// Returns a sentence that lists the parameters that are not identifiable and the measurements or options
// that would identify them.
std::string unidentified_finding(const std::vector<Reported>& all, const Grounds& on, const Uncertainty& u);

// Adds findings on parameters, and sums of weights, that lie at an end of the requested range.
void add_bound_findings(const std::vector<Reported>& all, const Grounds& on, Uncertainty& out);

// Returns "2 rows decide ks and alpha (rows 41 and 42 of the table): their intervals suppose that these
// rows scatter as the others do". Returns "" if every parameter is decided by four rows or more.
std::string few_rows_finding(const std::vector<Reported>& all, const Grounds& on, const SampleStream& stream);

}  // namespace brdf::fit
