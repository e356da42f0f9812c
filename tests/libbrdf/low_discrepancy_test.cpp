// The additive recurrence: its ratio generalises the golden ratio, its steps are inverse powers of the
// ratio, and its points leave no large gap.
#include "brdf/low_discrepancy.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace brdf {
namespace {

TEST(LowDiscrepancy, TheRatioGeneralisesTheGoldenOne) {
  EXPECT_EQ(generalised_golden_ratio(1), (1 + std::sqrt(5.0)) / 2);
  for (std::size_t d = 2; d <= 12; ++d) {
    const double x = generalised_golden_ratio(d);
    EXPECT_NEAR(std::pow(x, double(d + 1)), x + 1, 1e-14) << d;
    EXPECT_LT(x, generalised_golden_ratio(d - 1)) << d;
  }
}

TEST(LowDiscrepancy, StepsAreItsInversePowers) {
  constexpr auto steps = additive_recurrence_steps<3>();
  const double ratio = generalised_golden_ratio(3);
  for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(steps[k], std::pow(ratio, -double(k + 1)), 1e-16);
  EXPECT_TRUE(std::ranges::equal(steps, additive_recurrence_steps(3)));
  EXPECT_TRUE(additive_recurrence_steps(0).empty());
}

// In one dimension the gaps between the first n points of the golden recurrence have two or three sizes, of
// which the largest is below 2 / n.
TEST(LowDiscrepancy, PointsLeaveNoGap) {
  const double step = additive_recurrence_steps<1>()[0];
  for (const std::size_t n : {5u, 50u, 1000u}) {
    std::vector<double> points{0, 1};
    for (std::size_t k = 1; k <= n; ++k) points.push_back(additive_recurrence(0.5, step, k));
    std::sort(points.begin(), points.end());
    double gap = 0;
    for (std::size_t k = 1; k < points.size(); ++k) gap = std::max(gap, points[k] - points[k - 1]);
    EXPECT_LT(gap, 2 / double(n));
    EXPECT_GT(gap, 1 / double(n + 1));
  }
}

}  // namespace
}  // namespace brdf
