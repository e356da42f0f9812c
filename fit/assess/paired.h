// Whether one model predicts left-out rows worse than another beyond chance.
#pragma once

#include <vector>

#include "fit/model/row_groups.h"

namespace brdf::fit {

// One-sided probabilities of differences a - b as large as these where a is no worse than b: Student's t of the
// mean over all values, groups counted by their rows (the difference's error from the scatter between groups), and
// Wilcoxon's signed ranks of the groups' own differences, which a single group cannot decide. Exact to 25 groups,
// the normal approximation with ties beyond. 1 where fewer than two groups differ.
struct PairedTest {
  double t = 1, ranks = 1;
  bool worse() const { return t < 0.05 || ranks < 0.05; }
};
PairedTest paired_test(const std::vector<RowGroup>& groups, const std::vector<double>& a,
                       const std::vector<double>& b);

}  // namespace brdf::fit
