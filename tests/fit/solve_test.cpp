// Tests the solver on costs of one parameter.
#include "fit/solve/solve.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

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

TEST(Solve, NoPointIsEvaluatedTwiceAndTheSolutionIsOneOfThem) {
  for (const double start : {-2.0, 0.0, 0.7, 4.0}) {
    Cost cost{false, 0.3};
    const Solution s = solved(cost, start);
    EXPECT_EQ(s.termination, Termination::converged) << start;
    EXPECT_EQ(s.passes, int(cost.points.size()));
    const double least = std::ranges::min(cost.costs);
    // A last step that lowers the cost by less than the tolerance, 1e-12, is not taken.
    EXPECT_THAT(cost.points, testing::Contains(s.p[0])) << start;
    EXPECT_NEAR(s.cost, least, 1e-12 * s.cost) << start;
    std::vector<double> points = cost.points;
    std::ranges::sort(points);
    EXPECT_TRUE(std::ranges::adjacent_find(points) == points.end()) << start;
  }
}

TEST(Solve, EndsBeforeAStepThatRoundingDecides) {
  Cost cost{true, 1};
  const Solution s = solved(cost, 0);
  EXPECT_EQ(s.termination, Termination::converged);
  EXPECT_THAT(s.message, HasSubstr("less than its rounding"));
  EXPECT_NEAR(s.p[0], 3, 1e-7);  // the square of this distance is 1e-14 of twice the cost
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

}  // namespace
}  // namespace brdf::fit
