// The literal misprints of the source thesis, named by its equation numbers, and the effect of each.
#include <gtest/gtest.h>

#include <cmath>

#include "brdf/material.h"
#include "brdf/microfacet.h"

namespace brdf {
namespace {

// T8: D of GGX with pi inside the square, a^2/(pi (n.h)^2 (a^2 - 1) + 1)^2.
TEST(Misprints, T8HasAPoleAndNoPeak) {
  const double a = 0.1;
  const auto literal = [&](double nh) { return a * a / square(kPi * nh * nh * (a * a - 1) + 1); };
  const Vec3<double> n{0, 0, 1};
  const auto meant = d_ggx(Roughness<double>{a, a}, geometry(n, n));
  EXPECT_NEAR(literal(1), 0.00225, 5e-6);
  EXPECT_NEAR(meant.num / meant.den, 31.8, 0.05);
  const double pole = 1 / std::sqrt(kPi * (1 - a * a));
  EXPECT_NEAR(pole, 0.567, 5e-4);
  EXPECT_GT(literal(pole), 1e25);
}

// T12 divides by alpha^2 inside the tangent: exp(-tan^2((h.n)/alpha^2)).
TEST(Misprints, T12OscillatesInsteadOfFalling) {
  const double alpha = 0.15;
  const auto literal = [&](double nh) { return std::exp(-square(std::tan(nh / (alpha * alpha)))); };
  EXPECT_NEAR(1 / (alpha * alpha), 44.4, 0.05);  // radians, at the peak
  EXPECT_NEAR(literal(1), 0.78, 0.005);
  int crossings = 0;  // of the level 1/2, over half vectors within 45 degrees; a lobe has one crossing
  for (int k = 1; k <= 4000; ++k) {
    const auto nh = [](int j) { return std::cos(j * kPi / 4 / 4000); };
    crossings += (literal(nh(k)) < 0.5) != (literal(nh(k - 1)) < 0.5);
  }
  EXPECT_GE(crossings, 7);
}

// T13 prints the anisotropic exponential without its minus sign.
TEST(Misprints, T13GrowsAwayFromThePeak) {
  const double slope = 3;  // in widths
  EXPECT_NEAR(std::exp(slope * slope), 8103, 1);
  EXPECT_NEAR(std::exp(slope * slope) / std::exp(-slope * slope), 6.6e7, 0.1e7);
}

// T14 prints cos(theta_i) for cos(phi_i) in the x coordinate sin(theta_i) cos(phi_i) of a direction.
TEST(Misprints, T14ExtinguishesTheHighlight) {
  const double theta = kPi / 3, alpha = 0.15;
  const auto x = [&](double phi, bool literal) {
    return std::sin(theta) * (literal ? std::cos(theta) : std::cos(phi));
  };
  // A mirror pair in the plane of the tangent, which is the peak of the lobe.
  const auto lobe = [&](bool literal) {
    const double slope = (x(0, literal) + x(kPi, literal)) / (2 * std::cos(theta));
    return std::exp(-square(slope / alpha));
  };
  EXPECT_NEAR(lobe(false), 1, 1e-15);
  EXPECT_LT(lobe(true), 1e-14);
  EXPECT_GT(lobe(true), 1e-15);
}

}  // namespace
}  // namespace brdf
