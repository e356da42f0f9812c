// Tests the solvers on costs of few parameters, and the minimisation of a quadratic within bounds.
#include "fit/solve/solve.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <span>
#include <vector>

#include "fit/algebra/box_quadratic.h"
#include "fit/solve/nearby.h"

namespace brdf::fit {
namespace {

using testing::HasSubstr;
using testing::Not;

// The cost of the residuals exp(x) - 2 and rest (x - 0.5), or of x - 3 and the constant rest, with a record
// of the points.
struct Cost {
  bool linear;
  double rest;
  std::vector<double> points{}, costs{};

  NormalEquations operator()(std::span<const double> p) {
    const double x = p[0], e = std::exp(x);
    const double r = linear ? x - 3 : e - 2, slope = linear ? 1 : e;
    const double other = linear ? rest : rest * (x - 0.5), other_slope = linear ? 0 : rest;
    NormalEquations n{Matrix(1, 1), {r * slope + other * other_slope}, 0.5 * (r * r + other * other)};
    n.hessian(0, 0) = slope * slope + other_slope * other_slope;
    points.push_back(x);
    costs.push_back(n.cost);
    return n;
  }
};

Solution solved(Cost& cost, double start) {
  const Objective objective = [&](std::span<const double> p) { return cost(p); };
  const std::vector<double> from{start}, low{-100.0}, high{100.0};
  return solve(objective, from, low, high, {});
}

TEST(Solve, NoPointIsEvaluatedTwice) {
  for (const double start : {-2.0, 0.0, 0.7, 4.0}) {
    Cost cost{false, 0.3};
    const Solution s = solved(cost, start);
    EXPECT_EQ(s.termination, Termination::converged) << start;
    EXPECT_EQ(s.passes, int(cost.points.size()));
    EXPECT_NEAR(s.cost, std::ranges::min(cost.costs), 1e-12 * s.cost) << start;
    std::vector<double> points = cost.points;
    std::ranges::sort(points);
    EXPECT_TRUE(std::ranges::adjacent_find(points) == points.end()) << start;
  }
}

// The cost alone places a minimum to half of its digits: a step that it does not notice may be as long as
// 1e-7. The last step comes nearer to the root of the derivative.
TEST(Solve, TheLastStepPlacesTheMinimum) {
  constexpr double kRest = 0.3;
  double below = 0, above = 1;
  for (int k = 0; k < 60; ++k) {
    const double x = 0.5 * (below + above);
    const double slope = std::exp(x) * (std::exp(x) - 2) + kRest * kRest * (x - 0.5);
    (slope < 0 ? below : above) = x;
  }
  for (const double start : {-2.0, 0.0, 0.7, 4.0}) {
    Cost cost{false, kRest};
    EXPECT_NEAR(solved(cost, start).p[0], below, 1e-10) << start;
  }
}

TEST(Solve, EndsBeforeAStepThatRoundingDecides) {
  Cost cost{true, 1};
  const Solution s = solved(cost, 0);
  EXPECT_EQ(s.termination, Termination::converged);
  EXPECT_THAT(s.message, HasSubstr("less than its rounding"));
  EXPECT_EQ(cost.points.size(), 3u);  // the fourth point would change the cost by less than 1e-14 of it
  EXPECT_NEAR(s.p[0], 3, 1e-15);
}

// The last step of a minimum at a bound may lead out of the bounds: it is left out.
TEST(Solve, TheLastStepStaysWithinTheBounds) {
  Cost cost{true, 1};
  const Objective objective = [&](std::span<const double> p) { return cost(p); };
  for (const double high : {3 - 1e-9, 3.0, 3 + 1e-9}) {
    const Solution s = solve(objective, std::vector{0.0}, std::vector{-100.0}, std::vector{high}, {});
    EXPECT_LE(s.p[0], high);
    EXPECT_NEAR(s.p[0], std::min(high, 3.0), high < 3 ? 2e-8 : 1e-15);
  }
}

// Without any rest each step removes nearly the whole cost, however small the cost is.
TEST(Solve, DoesNotEndEarlyIfTheModelIsExact) {
  Cost cost{true, 0};
  const Solution s = solved(cost, 0);
  EXPECT_EQ(s.termination, Termination::converged);
  EXPECT_THAT(s.message, Not(HasSubstr("less than its rounding")));
  EXPECT_NEAR(s.p[0], 3, 1e-11);
}

TEST(Solve, FailsWithoutAFiniteCost) {
  const Objective objective = [](std::span<const double>) {
    return NormalEquations{Matrix(1, 1), {NAN}, NAN};
  };
  const std::vector<double> from{0.0}, low{-1.0}, high{1.0};
  EXPECT_EQ(solve(objective, from, low, high, {}).termination, Termination::failed);
}

// The cost is almost flat along the curve y = exp(x) and steep beside it; the least is at (1, e).
NormalEquations curved_valley(std::span<const double> p) {
  constexpr double kSteep = 100, kRest = 0.3;
  const double curve = std::exp(p[0]), beside = kSteep * (p[1] - curve), along = 1 - p[0];
  NormalEquations n{Matrix(2, 2),
                    {-kSteep * curve * beside - along, kSteep * beside},
                    0.5 * (beside * beside + along * along + kRest * kRest)};
  n.hessian(0, 0) = kSteep * kSteep * curve * curve + 1;
  n.hessian(0, 1) = n.hessian(1, 0) = -kSteep * kSteep * curve;
  n.hessian(1, 1) = kSteep * kSteep;
  return n;
}

// With a damping that always changes by a factor of ten, many steps failed: 148 passes from -1.2.
TEST(SolveNearby, FollowsACurvedValleyWithoutManyFailedSteps) {
  const std::vector<double> low{-100, -100}, high{100, 100};
  for (const auto& [x, passes] : {std::pair{-1.2, 42}, std::pair{3.0, 7}}) {
    const Solution s = solve_nearby(curved_valley, std::vector{x, 1.0}, low, high, {});
    EXPECT_EQ(s.termination, Termination::converged) << x;
    EXPECT_NEAR(s.p[0], 1, 1e-8) << x;
    EXPECT_NEAR(s.p[1], std::exp(1), 1e-7) << x;
    EXPECT_NEAR(s.passes, passes, passes / 2) << x;
  }
}

struct BoxProblem {
  Matrix hessian;
  std::vector<double> gradient, low, high;
};

// Returns the quadratic of `channels` channels with `own` unknowns each and one unknown that all share, in
// which each row of residuals concerns the unknowns of a single channel, and bounds that hold most of
// the unknowns.
BoxProblem channels_that_share_one(std::size_t channels, std::size_t own, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  const std::size_t n = own * channels + 1;
  BoxProblem out{Matrix(n, n), std::vector<double>(n, 0), std::vector<double>(n), std::vector<double>(n)};
  for (std::size_t c = 0; c < channels; ++c)
    for (std::size_t row = 0; row < own + 2; ++row) {
      const auto unknown = [&](std::size_t i) { return i == 0 ? 0 : own * c + i; };
      std::vector<double> slopes(own + 1);
      for (double& slope : slopes) slope = normal(random);
      const double residual = normal(random);
      for (std::size_t i = 0; i <= own; ++i) {
        out.gradient[unknown(i)] += slopes[i] * residual;
        for (std::size_t j = 0; j <= own; ++j) out.hessian(unknown(i), unknown(j)) += slopes[i] * slopes[j];
      }
    }
  for (std::size_t k = 0; k < n; ++k) {
    out.low[k] = k % 4 == 1 ? 0 : -0.2;
    out.high[k] = k % 4 == 2 ? 0 : 0.2;
  }
  return out;
}

// Returns the largest slope that a move within the bounds could follow downhill: 0 at the minimum.
double slope_left(const BoxProblem& q, std::span<const double> x) {
  double left = 0;
  for (std::size_t k = 0; k < x.size(); ++k) {
    double slope = q.gradient[k];
    for (std::size_t j = 0; j < x.size(); ++j) slope += q.hessian(k, j) * x[j];
    if (x[k] > q.low[k]) left = std::max(left, slope);
    if (x[k] < q.high[k]) left = std::max(left, -slope);
  }
  return left;
}

// 31 channels are factored as a sparse matrix; 2 channels as a dense one, and so is a channel of 40 unknowns.
TEST(BoxQuadratic, LeavesNoSlopeWithinTheBoundsForFewChannelsAndForMany) {
  for (const auto& [channels, own] : {std::pair{2u, 3u}, {31u, 3u}, {1u, 40u}}) {
    double bound = 0, all = 0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
      const BoxProblem q = channels_that_share_one(channels, own, seed);
      const std::vector<double> x = box_quadratic(q.hessian, q.gradient, q.low, q.high);
      for (std::size_t k = 0; k < x.size(); ++k) {
        ASSERT_GE(x[k], q.low[k]);
        ASSERT_LE(x[k], q.high[k]);
        bound += x[k] == q.low[k] || x[k] == q.high[k];
        ++all;
      }
      EXPECT_LT(slope_left(q, x), 1e-13) << channels << " channels, seed " << seed;
      EXPECT_GT(slope_left(q, std::vector<double>(x.size(), 0.0)), 1);  // the start is not the minimum
    }
    EXPECT_NEAR(bound / all, 0.6, 0.2) << channels << " channels";
  }
}

// Two unknowns of each channel have the same effect, so that only their sum is determined.
TEST(BoxQuadratic, LeavesNoSlopeIfUnknownsOfManyChannelsDependOnEachOther) {
  BoxProblem q = channels_that_share_one(31, 3, 1);
  const std::size_t n = q.gradient.size();
  for (std::size_t k = 2; k < n; k += 3) {
    for (std::size_t j = 0; j < n; ++j) q.hessian(k, j) = q.hessian(k - 1, j);
    for (std::size_t i = 0; i < n; ++i) q.hessian(i, k) = q.hessian(i, k - 1);
    q.gradient[k] = q.gradient[k - 1];
  }
  const std::vector<double> x = box_quadratic(q.hessian, q.gradient, q.low, q.high);
  EXPECT_LT(slope_left(q, x), 1e-12);
}

}  // namespace
}  // namespace brdf::fit
