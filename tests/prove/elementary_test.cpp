// The enclosures of elementary functions contain the true value, computed by MPFR in 50 digits, and are
// narrow.
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/mpfr.hpp>
#include <random>

#include "prove/scalar/elementary.h"
#include "tests/thorough.h"

namespace brdf::prove {
namespace {

const int kPoints = thorough() ? 1000000 : 5000;

using Mpfr = boost::multiprecision::mpfr_float_50;
using Engine = std::mt19937_64;

struct Worst {
  long outside = 0;
  double width = 0;  // relative
  double at = 0;
};
void hold(Worst& worst, Bounds b, const Mpfr& truth, double at) {
  if (!(Mpfr(b.lo) <= truth && truth <= Mpfr(b.hi))) {
    ++worst.outside;
    worst.at = at;
  }
  const double size = std::abs(double(truth));
  if (size > 1e-300) worst.width = std::max(worst.width, (b.hi - b.lo) / size);
}

template <class Draw, class Enclose, class Truth>
void expect(int count, const Draw& draw, const Enclose& enclose, const Truth& truth, double widest) {
  Engine e(7);
  Worst worst;
  for (int k = 0; k < count; ++k) {
    const double x = draw(e);
    hold(worst, enclose(x), truth(Mpfr(x)), x);
  }
  EXPECT_EQ(worst.outside, 0) << "at " << worst.at;
  EXPECT_LT(worst.width, widest);
}

Mpfr erfc(const Mpfr& x) {
  Mpfr y;
  mpfr_erfc(y.backend().data(), x.backend().data(), MPFR_RNDN);
  return y;
}

auto between(double low, double high) {
  return [=](Engine& e) { return std::uniform_real_distribution(low, high)(e); };
}
auto scales(double low, double high) {  // powers of ten
  return [=](Engine& e) { return std::pow(10, std::uniform_real_distribution(low, high)(e)); };
}

TEST(Elementary, ExpHoldsTheTruth) {
  const auto truth = [](const Mpfr& x) { return Mpfr(exp(x)); };
  expect(kPoints, between(-700, 709), exp_at, truth, 2e-14);
  expect(kPoints, between(-1, 1), exp_at, truth, 2e-14);
}

TEST(Elementary, LogarithmsHoldTheTruth) {
  const auto truth = [](const Mpfr& x) { return Mpfr(log(x)); };
  expect(kPoints, scales(-300, 300), log_at, truth, 2e-14);
  expect(kPoints, between(0.6, 1.6), log_at, truth, 2e-14);
  expect(
      kPoints, scales(-20, 30), log1p_at, [](const Mpfr& x) { return Mpfr(log1p(x)); }, 2e-14);
  expect(
      kPoints, between(-1, 1), log1p_at, [](const Mpfr& x) { return Mpfr(log1p(x)); }, 2e-14);
}

TEST(Elementary, ErfcxHoldsTheTruth) {
  const auto truth = [](const Mpfr& x) { return Mpfr(exp(x * x) * erfc(x)); };
  expect(kPoints, between(0, 11), erfcx_at, truth, 5e-13);
  expect(kPoints, between(0.9, 1.1), erfcx_at, truth, 5e-13);
}

TEST(Elementary, SineAndCosineHoldTheTruth) {
  const auto sine = [](const Mpfr& x) { return Mpfr(sin(x)); };
  const auto cosine = [](const Mpfr& x) { return Mpfr(cos(x)); };
  expect(kPoints, between(0, 1.6), sin_at, sine, 2e-14);
  expect(kPoints, between(0, 1.5), cos_at, cosine, 1e-13);
  expect(kPoints, scales(-12, 0), sin_at, sine, 2e-14);
  expect(kPoints, between(1.5, 1.6), cos_at, cosine, 1e-6);  // near the zero of the cosine: absolute
}

TEST(Elementary, TheAngleHoldsTheTruth) {
  Engine e(9);
  Worst worst;
  for (int k = 0; k < kPoints; ++k) {
    const double sine = scales(-13, 0)(e), cosine = scales(-13, 0)(e);
    hold(worst, angle_at(sine, cosine), Mpfr(atan2(Mpfr(sine), Mpfr(cosine))), sine);
  }
  EXPECT_EQ(worst.outside, 0) << "at " << worst.at;
  EXPECT_LT(worst.width, 2e-14);
  const Mpfr pi = boost::math::constants::pi<Mpfr>();
  EXPECT_LT(Mpfr(kPiBounds.lo), pi);
  EXPECT_LT(pi, Mpfr(kPiBounds.hi));
}

}  // namespace
}  // namespace brdf::prove
