#include "trade/measure/domain.h"

#include <gtest/gtest.h>

#include <cmath>

#include "trade/measure/timing.h"

namespace brdf::trade {
namespace {

TEST(Domain, PointsFillTheBoxEvenlyAndHoldItsCorners) {
  const Domain domain{{{"a", 0, 1}, {"b", 1e-4, 1, true}}, {}, ""};
  const Points points = sample(domain, 1024);
  ASSERT_EQ(points.count(), 1024u + 4);
  int quarter = 0, corners = 0;
  for (const auto& at : points.at) {
    EXPECT_GE(at[0], 0);
    EXPECT_LE(at[0], 1);
    EXPECT_GE(at[1], 1e-4 * (1 - 1e-12));
    EXPECT_LE(at[1], 1 + 1e-12);
    quarter += at[0] < 0.5 && at[1] < 1e-2;
    corners += (at[0] == 0 || at[0] == 1) && (at[1] == 1e-4 || at[1] == 1);
  }
  EXPECT_NEAR(quarter, 256, 8);
  EXPECT_EQ(corners, 4);
}

TEST(Domain, LobePointsAreUnitDirectionsWhoseHalfVectorHasTheSlopeAskedFor) {
  const Points points = sample(lobe_domain({"alpha", 0.01, 1, true}, {"-", 0, 0}), 512);
  ASSERT_GT(points.count(), 200u);
  for (std::size_t k = 0; k < points.count(); ++k) {
    const auto at = [&](std::size_t c) { return points.columns[c][k]; };
    EXPECT_NEAR(std::hypot(at(0), at(1), at(2)), 1, 1e-12);
    EXPECT_NEAR(std::hypot(at(3), at(4), at(5)), 1, 1e-12);
    const double tangent = std::hypot(at(0) + at(3), at(1) + at(4)) / (at(2) + at(5));
    EXPECT_NEAR(tangent, points.at[k][0] * at(6), 1e-9 * (1 + tangent));
  }
}

TEST(Domain, SaysWhatVariesAndWhatIsFixed) {
  EXPECT_EQ(describe(Domain{{{"cos", 0, 1}, {"eta", 1.5, 1.5}, {"-", 0, 0}}, {}, "note"}),
            "cos 0..1; eta 1.5; note");
}

TEST(Timing, QuantilesInterpolate) {
  const std::vector<double> sorted{1, 2, 3, 5};
  EXPECT_DOUBLE_EQ(timing::quantile(sorted, 0), 1);
  EXPECT_DOUBLE_EQ(timing::quantile(sorted, 0.5), 2.5);
  EXPECT_DOUBLE_EQ(timing::quantile(sorted, 1), 5);
}

TEST(Timing, RunsEveryCallInEveryRound) {
  int a = 0, b = 0, rounds = 0;
  const std::vector<std::function<void()>> calls{[&] { ++a; }, [&] { ++b; }};
  timing::Options options;
  options.rounds = 5;
  options.least_seconds = 0;
  options.between = [&] { ++rounds; };
  const auto timings = timing::interleaved(calls, options);
  ASSERT_EQ(timings.size(), 2u);
  EXPECT_EQ(timings[1].rounds, 5);
  EXPECT_EQ(rounds, 5);
  EXPECT_GE(a, 6);  // one to warm, one a round
  EXPECT_GE(b, 6);
  EXPECT_LE(timings[0].lower, timings[0].upper);
}

TEST(Timing, RatiosAreToTheFirstCallBesideEach) {
  // The machine slows down as it goes; pairs of neighbours do not feel it.
  double drift = 1;
  volatile double sink = 0;
  const auto work = [&](int n) {
    return [&, n] {
      for (int k = 0; k < int(n * drift); ++k) sink = sink + 1.0 / (k + 1);
    };
  };
  const std::vector<std::function<void()>> calls{work(20000), work(40000), work(10000)};
  timing::Options options;
  options.clock = timing::Clock::thread;
  options.between = [&] { drift *= 1.05; };  // 2.8 times slower in the end
  const auto timings = timing::interleaved(calls, options);
  EXPECT_EQ(timings[0].ratio, 1);
  EXPECT_NEAR(timings[1].ratio, 2, 0.5);
  EXPECT_NEAR(timings[2].ratio, 0.5, 0.125);
  options.neighbours = calls.size();
  EXPECT_NEAR(timing::interleaved(calls, options)[1].ratio, 2, 0.5);
}

TEST(Timing, ThePinnedThreadIsFreedAgain) {
  cpu_set_t before, within, after;
  sched_getaffinity(0, sizeof before, &before);
  {
    const timing::Pinned pinned;
    sched_getaffinity(0, sizeof within, &within);
  }
  sched_getaffinity(0, sizeof after, &after);
  EXPECT_EQ(CPU_COUNT(&within), 1);
  EXPECT_TRUE(CPU_EQUAL(&before, &after));
}

TEST(Domain, RoundsToFloat) {
  EXPECT_EQ(as_float(0.1), double(0.1f));
  EXPECT_NE(as_float(0.1), 0.1);
}

}  // namespace
}  // namespace brdf::trade
