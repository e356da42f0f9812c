// The elementary kernels against the C library in long double. The bounds are in units of the last place
// and hold on both sides.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "brdf/math.h"
#include "libbrdf/src/integrals/functions.h"

namespace brdf {
namespace {

template <class T>
struct Kernels : ::testing::Test {};
using Plain = ::testing::Types<float, double>;
TYPED_TEST_SUITE(Kernels, Plain);

// Returns the largest relative error, in units of epsilon, of `ours` against `exact` over `count` points of
// the map x(t), t in (0, 1).
template <class T, class X, class Ours, class Exact>
double worst_ulp(int count, X x, Ours ours, Exact exact) {
  long double worst = 0;
  for (int k = 1; k < count; ++k) {
    const T v = x(T(k) / T(count));
    const long double truth = exact((long double)(v));
    if (truth != 0) worst = std::max(worst, std::abs((long double)(ours(v)) / truth - 1));
  }
  return double(worst / std::numeric_limits<T>::epsilon());
}

void expect_between(double value, double low, double high) {
  EXPECT_GT(value, low);
  EXPECT_LT(value, high);
}

TYPED_TEST(Kernels, ExpIsWithinOneUlp) {
  using T = TypeParam;
  const double worst = worst_ulp<T>(
      200000, [](T t) { return T(-60) * t; }, [](T x) { return math::exp(x); },
      [](long double x) { return expl(x); });
  expect_between(worst, 0.4, 1.0);
}

TYPED_TEST(Kernels, LogIsWithinOneUlp) {
  using T = TypeParam;
  const double worst = worst_ulp<T>(
      200000, [](T t) { return T(4) * t * t + T(1e-6); }, [](T x) { return math::log(x); },
      [](long double x) { return logl(x); });
  expect_between(worst, 0.4, 1.0);
}

TYPED_TEST(Kernels, Log1pIsAccurateForTinyNegativeAndLargeArguments) {
  using T = TypeParam;
  const auto ours = [](T x) { return math::log1p(x); };
  const auto exact = [](long double x) { return log1pl(x); };
  expect_between(worst_ulp<T>(
                     100000, [](T t) { return T(1e-6) * t; }, ours, exact),
                 0.3, 1.5);
  expect_between(worst_ulp<T>(
                     100000, [](T t) { return T(-0.9999) * t; }, ours, exact),
                 0.4, 1.6);
  expect_between(worst_ulp<T>(
                     100000, [](T t) { return T(1e12) * t; }, ours, exact),
                 0.2, 1.5);
}

TYPED_TEST(Kernels, AngleIsWithinTwoUlpOverTheQuadrant) {
  using T = TypeParam;
  long double worst = 0;
  for (int k = 1; k < 100000; ++k) {
    const T s = T(std::sin(1.5707963 * k / 1e5)), c = T(std::cos(1.5707963 * k / 1e5));
    worst = std::max(worst, std::abs((long double)(math::angle(s, c)) / atan2l(s, c) - 1));
  }
  expect_between(double(worst / std::numeric_limits<T>::epsilon()), 0.6, 2.0);
  EXPECT_EQ(math::angle(T(0), T(1)), T(0));
  EXPECT_EQ(math::angle(T(1), T(0)), T(kPi / 2));
}

TYPED_TEST(Kernels, ErfcxIsWithinThreeUlp) {
  using T = TypeParam;
  const double worst = worst_ulp<T>(
      20000, [](T t) { return T(10.5) * t; }, [](T x) { return math::erfcx(x); },
      [](long double x) { return expl(x * x) * erfcl(x); });
  expect_between(worst, 0.6, 3.0);
}

// The functions of the integrals, over the quarters that sines are reduced to and over both series.
TEST(IntegralFunctions, AreWithinAFewUlp) {
  struct Case {
    const char* name;
    double (*ours)(double);
    long double (*exact)(long double);
    double from, to, low, high;
  };
  const Case cases[] = {
      {"sin", integrals::sin, sinl, -9, 10, .6, 1.5},    {"cos", integrals::cos, cosl, -9, 10, .6, 1.5},
      {"tan", integrals::tan, tanl, -1.57, 1.57, 1, 3},  {"atan", integrals::atan, atanl, -5, 7, .8, 3},
      {"acos", integrals::acos, acosl, -1, 1, .8, 4},    {"sinh", integrals::sinh, sinhl, -3, 4, .6, 3},
      {"cosh", integrals::cosh, coshl, -30, 40, .4, 2},  {"asinh", integrals::asinh, asinhl, -50, 60, .6, 3},
      {"cbrt", integrals::cbrt, cbrtl, 1e-9, 900, .4, 2}};
  for (const Case& c : cases) {
    SCOPED_TRACE(c.name);
    expect_between(worst_ulp<double>(
                       100000, [&](double t) { return c.from + (c.to - c.from) * t; }, c.ours, c.exact),
                   c.low, c.high);
  }
  // Next to a zero the rest of pi decides.
  EXPECT_NEAR(integrals::sin(3.141592653589793), 1.2246467991473532e-16, 1e-25);
  EXPECT_EQ(integrals::sin(0), 0);
  EXPECT_EQ(integrals::cos(0), 1);
  EXPECT_EQ(integrals::cbrt(0), 0);
  EXPECT_EQ(integrals::acos(1), 0);
  EXPECT_DOUBLE_EQ(integrals::hypot(3, -4), 5);
}

TYPED_TEST(Kernels, ExpFlushesToZeroInsteadOfSubnormals) {
  using T = TypeParam;
  const T lowest = T(std::is_same_v<T, float> ? -80 : -690);
  EXPECT_GT(math::exp(lowest), std::numeric_limits<T>::min());
  EXPECT_EQ(math::exp(std::nextafter(lowest, T(-1e9))), T(0));
  EXPECT_EQ(math::exp(-std::numeric_limits<T>::infinity()), T(0));
}

TYPED_TEST(Kernels, LetNanThrough) {
  using T = TypeParam;
  const T nan = std::numeric_limits<T>::quiet_NaN();
  EXPECT_TRUE(std::isnan(math::exp(nan)));
  EXPECT_TRUE(std::isnan(at_least(nan, T(0))));
  EXPECT_TRUE(std::isnan(at_most(nan, T(0))));
}

TYPED_TEST(Kernels, PowerOfZeroIsZero) {
  using T = TypeParam;
  EXPECT_EQ(math::pow(T(0), T(1 / 2.2)), T(0));
  EXPECT_NEAR(math::pow(T(0.5), T(2)), T(0.25), T(4) * std::numeric_limits<T>::epsilon());
}

}  // namespace
}  // namespace brdf
