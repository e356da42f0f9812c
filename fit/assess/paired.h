// Whether one model predicts left-out rows worse than another beyond chance.
#pragma once

#include <vector>

#include "fit/model/row_groups.h"

namespace brdf::fit {

// One-sided probabilities of differences a - b as large as these where a is no worse than b: Student's t of
// the mean over all values, groups counted by their rows (the difference's error from the scatter between
// groups), and Wilcoxon's signed ranks of the groups' own differences, which a single group cannot decide.
// Exact to 25 groups, the normal approximation with ties beyond. 1 where fewer than two groups differ.
struct PairedTest {
  double t = 1, ranks = 1;
  double standard_error = 0;  // of the mean difference
  bool worse() const { return t < 0.05 || ranks < 0.05; }
};
PairedTest paired_test(const std::vector<RowGroup>& groups, const std::vector<double>& a,
                       const std::vector<double>& b);

// The same for the logarithm of the groups' ratios a/b, each group counted once; values below `rounding` are
// taken for it. What one model gains on another is nearer to a common factor than to a common amount, so that
// few groups decide.
double paired_ratio_test(const std::vector<double>& a, const std::vector<double>& b, double rounding);

}  // namespace brdf::fit
