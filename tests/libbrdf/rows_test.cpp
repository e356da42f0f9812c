// The elementary functions of a row of nodes against the C library in long double, with bounds on both
// sides.
#include "libbrdf/src/integrals/rows.h"
#include "brdf/quadrature.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "brdf/scalar.h"

namespace brdf::integrals {
namespace {

using Exact = std::function<long double(long double)>;

// The largest relative and absolute errors of both functions over a row of arguments, in units of epsilon.
struct Errors {
  double relative = 0, absolute = 0;
};
Errors errors(const std::vector<double>& x, const std::vector<double>& ours, const Exact& exact) {
  Errors worst;
  for (std::size_t k = 0; k < x.size(); ++k) {
    const long double truth = exact(x[k]), error = std::abs(ours[k] - truth);
    const auto in_epsilons = [](long double e) { return double(e / std::numeric_limits<double>::epsilon()); };
    worst.absolute = std::max(worst.absolute, in_epsilons(error));
    if (truth != 0) worst.relative = std::max(worst.relative, in_epsilons(error / std::abs(truth)));
  }
  return worst;
}

std::vector<double> log_spaced(double low, double high, int count) {
  std::vector<double> x;
  for (int k = 0; k <= count; ++k) x.push_back(low * std::pow(high / low, double(k) / count));
  return x;
}

TEST(Rows, HyperbolicFunctionsAreRelativelyAccurateForTinyAndLargeArguments) {
  for (const auto& [low, high] : {std::pair{1e-12, 0.5}, std::pair{0.5, 700.0}}) {
    const std::vector<double> s = log_spaced(low, high, 20000);
    std::vector<double> sinh(s.size()), cosh(s.size());
    quadrature::sinh_cosh(s.size(), s.data(), sinh.data(), cosh.data());
    const double of_sinh = errors(s, sinh, [](long double x) { return sinhl(x); }).relative;
    const double of_cosh = errors(s, cosh, [](long double x) { return coshl(x); }).relative;
    EXPECT_GT(of_sinh, 0.3);
    EXPECT_LT(of_sinh, 4);
    EXPECT_GT(of_cosh, 0.3);
    EXPECT_LT(of_cosh, 4);
  }
}

TEST(Rows, SineAndCosineAreAccurateOverHalfATurn) {
  std::vector<double> angle = log_spaced(1e-9, kPi, 40000);
  angle.push_back(0);
  std::vector<double> sine(angle.size()), cosine(angle.size());
  sin_cos(angle.size(), angle.data(), sine.data(), cosine.data());
  const double of_sine = errors(angle, sine, [](long double x) { return sinl(x); }).absolute;
  const double of_cosine = errors(angle, cosine, [](long double x) { return cosl(x); }).absolute;
  EXPECT_GT(of_sine, 0.3);
  EXPECT_LT(of_sine, 2.5);
  EXPECT_GT(of_cosine, 0.3);
  EXPECT_LT(of_cosine, 2.5);
  EXPECT_EQ(sine.back(), 0);
  EXPECT_EQ(cosine.back(), 1);
}

TEST(Rows, TheSineIsRelativelyAccurateNearZero) {
  const std::vector<double> angle = log_spaced(1e-12, kPi / 2, 20000);
  std::vector<double> sine(angle.size()), cosine(angle.size());
  sin_cos(angle.size(), angle.data(), sine.data(), cosine.data());
  EXPECT_LT(errors(angle, sine, [](long double x) { return sinl(x); }).relative, 3);
}

}  // namespace
}  // namespace brdf::integrals
