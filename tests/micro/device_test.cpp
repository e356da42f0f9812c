// Paths on a Vulkan device have the bits of the processor's paths.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <tuple>

#include "brdf/directions.h"
#include "brdf/material.h"
#include "io/files/error.h"
#include "micro/device_paths.h"
#include "micro/goniometer.h"
#include "micro/samples.h"
#include "micro/strata.h"

namespace brdf::micro {
namespace {

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

bool same(const Path& a, const Path& b) {
  return same_bits(a.travel.x, b.travel.x) && same_bits(a.travel.y, b.travel.y) &&
         same_bits(a.travel.z, b.travel.z) && same_bits(a.weight, b.weight) &&
         same_bits(a.absorbed, b.absorbed) && a.order == b.order && a.fate == b.fate;
}

constexpr std::uint32_t kUnprecise[] =
#include "paths_unprecise.comp.inc"
    ;

struct Count {
  int paths = 0, different = 0, reflected_often = 0;
};

// Compares paths over surfaces of all kinds, from the normal to grazing directions.
Count compare(DevicePaths& device) {
  struct Case {
    Simulation simulation;
    double eta;
    int limit;
  };
  std::vector<Case> cases;
  for (const auto& [x, y, eta, limit] :
       {std::tuple{0.3, 0.3, 0.0, 64}, {1.2, 0.15, 1.5, 64}, {0.05, 0.05, 2.0, 1}})
    cases.push_back({{.geometry = HeightField{.alpha_x = x, .alpha_y = y, .size = 64}}, eta, limit});
  cases.push_back({{.geometry = Grooves{GrooveAngles::beckmann, 0.7, 128}}, 1.3, 8});
  Count count;
  for (const Case& c : cases) {
    const Surface surface = make_surface(c.simulation, 0);
    March march = surface.march();
    for (const double theta : {0.0, 0.9, 1.5}) {
      const Vec wi = direction(radians(theta), radians(2.2));
      Random random(41);
      std::vector<Start> starts;
      for_each_stratum(5476, random, [&](double u, double v) { starts.push_back({u, v}); });
      auto from = starts.begin();
      device.follow(surface, wi, c.eta, c.limit, starts, [&](const Path& path) {
        count.different += !same(path, march.path_over_mirrors(wi, from->u, from->v, c.eta, c.limit));
        count.reflected_often += path.order > 2;
        ++count.paths;
        ++from;
      });
    }
  }
  return count;
}

// A device that may round in another way is no subject of this test.
TEST(DevicePaths, HaveTheBitsOfTheProcessor) {
  DevicePaths device;
  if (!device.is_software()) GTEST_SKIP() << device.device() << " may round in another way";
  const Count count = compare(device);
  EXPECT_EQ(count.different, 0);
  EXPECT_EQ(count.paths, 12 * 5476);
  EXPECT_GT(count.reflected_often, 200);
}

// The driver rearranges arithmetic that is not marked `precise`.
TEST(DevicePaths, DifferIfTheShaderIsNotPrecise) {
  DevicePaths device(kUnprecise);
  if (!device.is_software()) GTEST_SKIP() << device.device() << " may round in another way";
  EXPECT_GT(compare(device).different, 1000);
}

// More paths than one dispatch holds, and surfaces of different sizes one after the other.
TEST(DevicePaths, TraceTheSamplesOfTheProcessor) {
  if (!DevicePaths().is_software()) GTEST_SKIP() << "the device may round in another way";
  SampleSettings settings{
      .parameters = {{"alpha", 0.5}, {"eta", 1.6}}, .theta_i = {50}, .surfaces = 8, .rays = 70000};
  settings.size = 64;
  const io::SampleTable here = trace_samples(settings);
  settings.gpu = true;
  const io::SampleTable there = trace_samples(settings);
  EXPECT_EQ(here.values, there.values);
  EXPECT_EQ(here.sigma, there.sigma);
  EXPECT_EQ(here.theta_o, there.theta_o);
  EXPECT_GT(here.rows(), 100u);
  EXPECT_EQ(there.metadata.size(), here.metadata.size() + 1);
  EXPECT_EQ(there.metadata.back().first, "device");
}

TEST(DevicePaths, AreOverMirrorsOnly) {
  SampleSettings settings{.surface = "lambert_grooves"};
  settings.gpu = true;
  try {
    trace_samples(settings);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()),
              "--gpu: follows rays over mirrors only; the facets of lambert_grooves draw random numbers on "
              "the way. "
              "Leave --gpu out");
  }
}

}  // namespace
}  // namespace brdf::micro
