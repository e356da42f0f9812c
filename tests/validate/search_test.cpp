// The search for a maximum: exact peaks and corners, determinism, NaN, rough functions, and the even cover
// of the domain.
#include "validate/search/search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace brdf::validate {
namespace {

TEST(Search, FindsTheHighestOfTwoPeaks) {
  const auto f = [](std::span<const double> x) {
    const auto peak = [&](double a, double b) {
      return std::exp(-80 * (std::pow(x[0] - a, 2) + std::pow(x[1] - b, 2)));
    };
    return peak(0.2, 0.3) + 1.1 * peak(0.8, 0.63);
  };
  const Best best = maximise(f, 2, {});
  EXPECT_NEAR(best.point[0], 0.8, 1e-4);
  EXPECT_NEAR(best.point[1], 0.63, 1e-4);
}

TEST(Search, ReachesACornerExactly) {
  const Best best = maximise([](std::span<const double> x) { return x[0] - x[1] + x[2]; }, 3, {});
  EXPECT_EQ(best.point, (std::vector<double>{1, 0, 1}));
}

TEST(Search, IsDeterministic) {
  const auto f = [](std::span<const double> x) { return std::sin(40 * x[0]) + std::cos(31 * x[1]); };
  EXPECT_EQ(maximise(f, 2, {}).point, maximise(f, 2, {}).point);
}

TEST(Search, IgnoresNaN) {
  const Best best = maximise([](std::span<const double> x) { return x[0] > 0.5 ? NAN : x[0]; }, 1, {});
  EXPECT_NEAR(best.value, 0.5, 1e-5);
}

TEST(Search, TheBestSummitsArePolishedWithTheExactFunction) {
  // The left hill is the higher one in the rough function, the right hill in the exact function.
  const auto hills = [](double left, double right) -> Objective {
    return [=](std::span<const double> x) {
      return left * std::exp(-50 * std::pow(x[0] - 0.25, 2)) +
             right * std::exp(-50 * std::pow(x[0] - 0.75, 2));
    };
  };
  const Best best = maximise(hills(1.01, 1), 1, {}, {}, hills(1, 1.01));
  EXPECT_NEAR(best.point[0], 0.75, 1e-3);
  EXPECT_NEAR(best.value, 1.01, 1e-5);
}

// A narrow hill under noise. A climb by equal steps does not overcome the noise.
TEST(Search, OfARoughFunctionFindsTheHillUnderTheNoise) {
  const auto f = [](std::span<const double> x) {
    double from = 0, seed = 0;
    for (std::size_t d = 0; d < x.size(); ++d) {
      from = std::max(from, std::abs(x[d] - 0.3 - 0.1 * double(d)));
      seed += x[d] * double(d + 1);
    }
    const double noise = std::abs(std::fmod(1e12 * seed, 1.0));
    return -std::log10(from + 1e-12) + 0.2 * noise;
  };
  const Best best = maximise_rough(f, 4, 10000, 1);
  for (std::size_t d = 0; d < 4; ++d) EXPECT_NEAR(best.point[d], 0.3 + 0.1 * double(d), 0.01);
  EXPECT_EQ(best.calls, 10000);
  EXPECT_EQ(maximise_rough(f, 4, 10000, 1).point, best.point);
}

TEST(Search, TheCoverIsEvenlySpread) {
  int quadrant[4] = {};
  for (std::size_t k = 0; k < 400; ++k) {
    const auto p = cover_point(k, 2, 1);
    ++quadrant[(p[0] > 0.5) + 2 * (p[1] > 0.5)];
  }
  for (const int count : quadrant) EXPECT_NEAR(count, 100, 8);
}

// Each climb stands for itself, so that threads change nothing.
TEST(Search, SeveralThreadsFindWhatOneFinds) {
  const auto f = [](std::span<const double> x) {
    return std::sin(9 * x[0]) * std::cos(7 * x[1]) - x[2] * x[2];
  };
  const Best one = maximise(f, 3, {}, cube_corners(3, 3), f);
  const Best several = maximise(f, 3, {.any_thread = true}, cube_corners(3, 3), f);
  EXPECT_EQ(several.point, one.point);
  EXPECT_EQ(several.value, one.value);
  EXPECT_EQ(several.calls, one.calls);
}

}  // namespace
}  // namespace brdf::validate
