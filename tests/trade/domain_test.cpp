// Tests the points and kernels of measurements, and the timing of calls.
#include "trade/measure/domain.h"

#include <gtest/gtest.h>

#include <cmath>

#include "brdf/angle.h"
#include "trade/measure/timing.h"

namespace brdf::trade {
namespace {

TEST(Domain, PointsFillTheBoxEvenlyAndHoldItsCorners) {
  const Domain domain = make_domain({{"a", 0, 1}, {"b", 1e-4, 1, true}}, [](std::span<const double> at) {
    return CosineRow<double>{at[0], at[1]};
  });
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
  const Points points = sample(lobe_domain({"alpha", 0.01, 1, true}), 512);
  ASSERT_GT(points.count(), 200u);
  for (std::size_t k = 0; k < points.count(); ++k) {
    const auto row = row_at<DirectionRow>(points.columns, k);
    EXPECT_NEAR(dot(row.wi, row.wi), 1, 1e-12);
    EXPECT_NEAR(dot(row.wo, row.wo), 1, 1e-12);
    const Vec3<double> h = row.wi + row.wo;
    const double tangent = std::hypot(h.x, h.y) / h.z;
    EXPECT_NEAR(tangent, points.at[k][0] * row.width, 1e-9 * (1 + tangent));
  }
}

TEST(Domain, AWidthAndF0StandInTheRowWhereThereAreAxesForThem) {
  const Points points = sample(direction_domain(0, 80, {{"alpha", 0.1, 0.2}, {"f0", 0.5, 0.9}}), 32);
  ASSERT_EQ(points.count(), 32u + 32);
  for (std::size_t k = 0; k < points.count(); ++k) {
    const auto row = row_at<DirectionRow>(points.columns, k);
    EXPECT_EQ(row.width, points.at[k][3]);
    EXPECT_EQ(row.f0, points.at[k][4]);
    EXPECT_NEAR(std::acos(row.wi.z), degrees(points.at[k][0]).radians(), 1e-7);
  }
  EXPECT_EQ(row_at<DirectionRow>(sample(direction_domain(0, 80), 1).columns, 0).width, 0);
}

struct half_cosine {
  template <class T>
  T operator()(const CosineRow<T>& x) const {
    return T(0.5) * x.cosine;
  }
};

TEST(Kernel, ReadsRowsOfItsKindAndNoOthers) {
  const Columns<double> columns{{1, 3}, {0, 0}, {0, 0}};
  std::vector<double> out(2);
  kernel(half_cosine{}).in_double(pointers(columns), out);
  EXPECT_EQ(out, (std::vector<double>{0.5, 1.5}));
  scalar_kernel([](const CosineRow<double>& x) { return 2 * x.cosine; }).in_double(pointers(columns), out);
  EXPECT_EQ(out, (std::vector<double>{2, 6}));
  EXPECT_THROW(kernel(half_cosine{}).in_double(pointers(Columns<double>{{1, 3}, {0, 0}}), out),
               std::logic_error);
}

TEST(Domain, SaysWhatVariesAndWhatIsFixed) {
  EXPECT_EQ(describe(Domain{{{"cos", 0, 1}, {"eta", 1.5, 1.5}}, {}, "note"}), "cos 0..1; eta 1.5; note");
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
  EXPECT_GE(a, 6);  // one to warm up, one per round
  EXPECT_GE(b, 6);
  EXPECT_LE(timings[0].lower, timings[0].upper);
}

TEST(Timing, RatiosAreToTheFirstCallBesideEach) {
  // The machine becomes slower during the test. Ratios of neighbouring calls must not be affected.
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
  options.between = [&] { drift *= 1.05; };  // 2.8 times slower at the end
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
