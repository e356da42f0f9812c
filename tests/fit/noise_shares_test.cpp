// Tests the quantiles of values divided by an error that a few of these values dominate.
#include "fit/solve/noise_shares.h"

#include <gtest/gtest.h>

#include "fit/assess/student.h"

namespace brdf::fit {
namespace {

NoiseShares shares(int large, double of_all, int small) {
  NoiseShares out;
  for (int k = 0; k < large; ++k) out.add(of_all / large);
  for (int k = 0; k < small; ++k) out.add((1 - of_all) / small);
  return out;
}

TEST(NoiseShares, AsManyEqualValuesAreStudentsT) {
  for (const int values : {1, 2, 4, 8, 20, 50, 200}) {
    EXPECT_NEAR(shares(values, 1, 0).freedom(), values, 1e-9 * values);
    EXPECT_NEAR(t_quantile(shares(values, 1, 0)) / t_quantile(double(values)), 1, 1e-3) << values;
  }
}

// One value has the share w of the error and many small values have the rest. The reference figures solve
// P(z^2 > c^2 (w x^2 + 1 - w)) = 0.05 by quadrature over x.
TEST(NoiseShares, ManySmallOnesBoundWhatOneLargeOneCanDo) {
  EXPECT_NEAR(t_quantile(shares(1, 0.5, 100000)), 2.30753, 1e-3);
  EXPECT_NEAR(t_quantile(shares(1, 0.7, 100000)), 2.72264, 1e-3);
  EXPECT_NEAR(t_quantile(shares(1, 0.9, 100000)), 3.91257, 2e-3);
  const NoiseShares half = shares(1, 0.5, 100000);
  EXPECT_NEAR(half.freedom(), 4, 1e-3);
  EXPECT_GT(t_quantile(half.freedom()), 2.7);
}

TEST(NoiseShares, OfNoneIsNormal) {
  EXPECT_FALSE(NoiseShares().any());
  EXPECT_NEAR(t_quantile(NoiseShares()), 1.959964, 1e-6);
}

}  // namespace
}  // namespace brdf::fit
