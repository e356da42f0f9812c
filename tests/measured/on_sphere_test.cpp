#include "measured/on_sphere.h"

#include <gtest/gtest.h>

#include <cmath>

#include "io/files/error.h"
#include "tests/measured/samples.h"

namespace brdf::measured {
namespace {

std::shared_ptr<const MeasuredReflectance> seen_of(const io::SampleTable& table, const Material& fit) {
  return std::make_shared<const MeasuredReflectance>(table, &fit);
}

TEST(OnSphere, GivesWhatWasMeasuredAndNothingBeyondTheScan) {
  const Material truth = lobes({{0.2, 0.3, 0.2}});
  const io::SampleTable table = scanned(truth, {0, 20, 40, 60}, 0);
  const auto seen = seen_of(table, truth);
  const io::sphere::MeasuredPairs pairs = on_sphere(seen);
  const Vec3<double> wi = direction(degrees(40), {}), wo = direction(degrees(30), degrees(170));
  const auto f = pairs(wi, wo);
  ASSERT_TRUE(f);
  double expected = 0;
  eval(truth, wi, wo, {&expected, 1});
  for (const double value : *f) EXPECT_NEAR(value, expected, 0.01 * expected);
  EXPECT_FALSE(pairs(direction(degrees(85), {}), direction(degrees(86), degrees(180))));
  EXPECT_EQ(table_size(*seen).phi_h, 1);
}

TEST(OnSphere, RefusesChannelsThatAreNoColours) {
  Material truth = lobes({{0.2, 0.3, 0.2}});
  io::SampleTable table = scanned(truth, {0, 30, 60}, 0);
  for (const char* channel : {"x", "y", "z"}) {
    table.channels.push_back(channel);
    table.values.push_back(table.values.front());
    table.sigma.push_back({});
  }
  EXPECT_THROW(on_sphere(seen_of(table, truth)), InputError);
}

}  // namespace
}  // namespace brdf::measured
