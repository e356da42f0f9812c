// Tests the quadrature rule over the aperture of a detector.
#include "brdf/aperture.h"
#include "brdf/forms.h"

#include <gtest/gtest.h>

#include <cmath>

#include "brdf/math.h"

namespace brdf {
namespace {

constexpr double kDegree = kPi / 180;

TEST(Aperture, NodesAreUnitVectorsWithinTheConeAndWeightsSumToOne) {
  for (const double width : {0.0, 0.1, 1.0, 30.0, 90.0}) {
    double sum = 0;
    for (const ApertureNode& node : aperture_nodes(degrees(width))) {
      sum += node.weight;
      EXPECT_NEAR(dot(node.direction, node.direction), 1, 1e-15);
      EXPECT_LE(std::atan2(std::hypot(node.direction.x, node.direction.y), node.direction.z),
                width / 2 * kDegree + 1e-15);
    }
    EXPECT_NEAR(sum, 1, 1e-15);
  }
  EXPECT_EQ(aperture_nodes({}).size(), 1u);
  EXPECT_EQ(aperture_nodes(radians(.01), kFitRings).size(), 24u);
  EXPECT_EQ(aperture_nodes(radians(.01), kSynthRings).size(), 288u);
}

TEST(Aperture, NodesTurnWithTheAxisAndKeepTheirDistance) {
  const auto nodes = aperture_nodes(degrees(2));
  for (const Vec3<double> axis : {Vec3<double>{0, 0, 1}, {0.6, 0, 0.8}, {-0.48, 0.6, 0.64}, {1, 0, 0}}) {
    for (const ApertureNode& node : nodes) {
      const Vec3<double> w = aperture_direction(axis, node);
      EXPECT_NEAR(dot(w, w), 1, 1e-15);
      EXPECT_NEAR(dot(w, axis), node.direction.z, 1e-15);
    }
  }
}

// Returns the mean over the cone of exp(-(t/s)^2) by a rule with this many rings; t is the small angle to
// the axis moved by `offset`. A fine rule gives the reference.
double gaussian_mean(double width, double s, double offset, int rings) {
  double sum = 0;
  for (const ApertureNode& node : aperture_nodes(radians(width), rings)) {
    const double x = node.direction.x - offset, y = node.direction.y;
    sum += node.weight * math::exp(-(x * x + y * y) / (s * s));
  }
  return sum;
}

TEST(Aperture, TheFittingRuleIsAsAccurateAsDocumented) {
  const double width = 1 * kDegree;
  const auto error = [&](double s, double offset, int rings) {
    return std::abs(gaussian_mean(width, s, offset, rings) / gaussian_mean(width, s, offset, 40) - 1);
  };
  EXPECT_LT(error(width / 4, 0, kFitRings), 2e-3);
  EXPECT_GT(error(width / 4, 0, kFitRings), 5e-4);
  EXPECT_LT(error(width, 0, kFitRings), 1e-6);
  EXPECT_LT(error(width / 4, 0, kSynthRings), 1e-13);
  // The closed form of the mean over the disc of radius r is s^2/r^2 (1 - exp(-r^2/s^2)).
  const double q = 16.0 / 4;
  EXPECT_NEAR(gaussian_mean(width, width / 4, 0, kSynthRings), (1 - std::exp(-q)) / q,
              1e-4 * (1 - std::exp(-q)) / q);
}

TEST(Aperture, ALambertianReadsTheSameThroughAnyApertureAwayFromTheHorizon) {
  const Material material = make_material(lambert{}, {"fr"});
  const auto nodes = aperture_nodes(degrees(10));
  const Vec3<double> wi = direction(radians(0.3), radians(1)), wo = direction(radians(1.2), radians(4));
  double value[1];
  eval_aperture(material, wi, wo, nodes, nodes, value);
  EXPECT_NEAR(value[0], 0.5 / kPi, 1e-15);
  // Half of the cone is below the horizon, and dark.
  eval_aperture(material, wi, direction(radians(kPi / 2), {}), aperture_nodes({}), nodes, value);
  EXPECT_NEAR(value[0], 0.25 / kPi, 0.05 / kPi);
}

}  // namespace
}  // namespace brdf
