// Tests whether one model predicts held-out rows worse than another beyond chance.
#pragma once

#include <vector>

#include "fit/model/row_groups.h"

namespace brdf::fit {

// One-sided p-values of the differences a - b under the hypothesis that a is no worse than b. `t`:
// Student's t test of the mean over all values, with groups weighted by their rows (the error of the
// difference comes from the scatter between groups). `ranks`: Wilcoxon's signed-rank test of the
// differences per group, which a single group cannot decide. The ranks are exact up to 25 groups; beyond,
// the normal approximation with ties is used. Both are 1 if fewer than two groups differ.
struct PairedTest {
  double t = 1, ranks = 1;
  double standard_error = 0;  // of the mean difference
  bool worse() const { return t < 0.05 || ranks < 0.05; }
};
// Compares the held-out values of two models, one for each group.
PairedTest paired_test(const std::vector<RowGroup>& groups, const std::vector<double>& a,
                       const std::vector<double>& b);

// Returns the p-value for the logarithms of the ratios a/b of the groups, with every group counted once.
// Values below `rounding` are replaced by `rounding`. An improvement of one model over another is closer to
// a common factor than to a common amount, so a few groups suffice.
double paired_ratio_test(const std::vector<double>& a, const std::vector<double>& b, double rounding);

}  // namespace brdf::fit
