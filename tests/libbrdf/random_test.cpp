// Normal random numbers: moments, correlation and tail agree with the distribution within four standard
// errors of 200,000 numbers, and the numbers are the same on every machine.
#include "brdf/random.h"

#include <gtest/gtest.h>

namespace brdf {
namespace {

TEST(Random, NormalNumbersHaveTheMomentsOfTheDistribution) {
  Random random(7);
  constexpr int kCount = 200000;
  double sum[5] = {}, product = 0, previous = 0;
  int beyond = 0;
  for (int k = 0; k < kCount; ++k) {
    const double x = random.normal();
    for (int power = 1; power <= 4; ++power) sum[power] += std::pow(x, power);
    product += x * previous;
    previous = x;
    beyond += std::abs(x) > 1.959964;
  }
  EXPECT_NEAR(sum[1] / kCount, 0, 4 * std::sqrt(1.0 / kCount));
  EXPECT_NEAR(sum[2] / kCount, 1, 4 * std::sqrt(2.0 / kCount));
  EXPECT_NEAR(sum[3] / kCount, 0, 4 * std::sqrt(15.0 / kCount));
  EXPECT_NEAR(sum[4] / kCount, 3, 4 * std::sqrt(96.0 / kCount));
  EXPECT_NEAR(product / kCount, 0, 4 * std::sqrt(1.0 / kCount));
  EXPECT_NEAR(double(beyond) / kCount, 0.05, 4 * std::sqrt(0.05 * 0.95 / kCount));
}

TEST(Random, NormalNumbersAreTheSameOnEveryMachine) {
  Random random(1);
  for (const double expected : {-0.039399956754155314, -0.38683176162103955, -0.24894784633514516})
    EXPECT_EQ(random.normal(), expected);
}

}  // namespace
}  // namespace brdf
