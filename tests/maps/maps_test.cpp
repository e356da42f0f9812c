// Compares maps of synthetic stacks with the truth from which the stacks were made.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <iostream>

#include "fit/assess/student.h"
#include "fit/fit.h"
#include "maps/page.h"
#include "tests/maps/case.h"

namespace brdf {
namespace {

TEST(Maps, WithoutNoiseAreTheTruthUnderGivenNormals) {
  expect_truth(16, false);
}

TEST(Maps, WithoutNoiseAreTheTruthWhereNormalsAreFitted) {
  expect_truth(16, true);
}

TEST(Maps, StandardErrorsCoverTheTruth) {
  expect_coverage(32, 0.9);
}

TEST(Maps, GiveThePictureUnderAnotherLight) {
  synth::TexelOptions o = small_stack(24, 151);
  for (const double noise : {0.0, 0.03}) {
    o.noise = noise;
    for (const bool fits_normal : {false, true}) {
      const Case c(o, fits_normal);
      const double decibels = psnr(c, c.fit());
      std::cout << "noise " << noise << ", normals " << (fits_normal ? "fitted" : "given") << ": " << decibels
                << " dB\n";
      EXPECT_GT(decibels, noise > 0 ? 35 : 90);
    }
  }
}

// Compares the minimum and the verdict with a fit of the texel's table alone.
void expect_same_as_tables(bool fits_normal) {
  synth::TexelOptions o = small_stack(16, 151);
  o.noise = 0.03;
  o.saturation = 3;
  const Case c(o, fits_normal);
  const texel::Planes maps = c.fit();
  for (std::size_t k = 5; k < 256; k += 23) {
    const std::size_t x = k % 16, y = k / 16;
    const auto at = [&](const std::string& name) { return double((*maps.find(name))[k]); };
    const texel::Region here{x, y, 1, 1};
    const std::vector<float> pixels = texel::read_region(c.stack, here);
    // A given normal is exactly the one that the fit used; the normal of the map is rounded to float.
    const texel::Planes& normals = fits_normal ? maps : c.truth;
    Vec3<double> n{double((*normals.find("normal.x"))[k]), double((*normals.find("normal.y"))[k]), 0};
    n.z = std::sqrt(1 - n.x * n.x - n.y * n.y);
    fit::FitOptions options;
    options.cross_validation = false;
    const fit::FitResult alone =
        fit::fit(maps::texel_table(c.stack, {pixels, x, y}, n), {c.settings.forms}, options);
    const fit::FormFit& best = alone.ranking[0];
    ASSERT_EQ(double(alone.rows), at("images")) << x << ", " << y;
    // The verdict of a texel does not include the check of energy conservation.
    if (!fits_normal && best.verdict != fit::Verdict::breaks_energy) {
      EXPECT_EQ(best.verdict, fit::Verdict(int(at("verdict")))) << x << ", " << y;
    }
    for (const fit::Estimate& e : best.estimates) {
      const std::string name = texel::plane_name(e.name, e.channel);
      if (e.status != fit::Status::free || e.standard_error > 0.3 * std::abs(e.value)) continue;
      // If a parameter is poorly determined, both fits stop at a cost with a relative accuracy of 1e-12.
      const double within = std::max(1e-6 * std::abs(e.value), 2e-5 * e.standard_error);
      EXPECT_NEAR(at(name), e.value, within) << name << " at " << x << ", " << y;
      if (fits_normal) continue;
      const double error = e.standard_error * fit::t_quantile(e.freedom) / 1.959964;
      // The standard error of the map is approximate: it omits the noise of all values together
      // (fit/assess/curvature.h).
      EXPECT_LT(std::abs(std::log(at("standard_error." + name) / error)), 1) << name;
    }
  }
}

TEST(Maps, AreThoseOfATexelsTableUnderGivenNormals) {
  expect_same_as_tables(false);
}

TEST(Maps, AreThoseOfATexelsTableWhereNormalsAreFitted) {
  expect_same_as_tables(true);
}

// The lights are at a distance of two widths of the sample. A texel at the edge sees them about 14 degrees
// away from their direction at the middle, and a fifth brighter.
TEST(Maps, OfNearLightsAreTheTruth) {
  synth::TexelOptions o = small_stack(8, 100);
  o.rig = {16, 20, 1};
  Case near(o, true);
  const auto worst = [&](const texel::Planes& maps) {
    double off = 0;
    for (const char* name : {"normal.x", "normal.y", "kd.r", "alpha_x"})
      for (std::size_t k = 0; k < 64; ++k)
        off = std::max(off, std::abs(double((*maps.find(name))[k]) - double((*near.truth.find(name))[k])));
    return off;
  };
  EXPECT_LT(worst(near.fit()), 2e-6);
  near.stack.rig = {};  // treated as distant
  EXPECT_GT(worst(near.fit()), 0.05);
}

TEST(Maps, DoNotDependOnMemoryOrThreads) {
  synth::TexelOptions o = small_stack(0, 24);
  o.width = 66;
  o.height = 6;
  o.noise = 0.03;
  const Case c(o, false);
  const texel::Planes one = c.fit(), two = c.fit(20000, 2);
  ASSERT_EQ(one.names, two.names);
  for (std::size_t k = 0; k < one.values.size(); ++k)
    EXPECT_EQ(0,
              std::memcmp(one.values[k].data(), two.values[k].data(), one.values[k].size() * sizeof(float)))
        << one.names[k];
}

TEST(Maps, LeaveOutWhatIsMasked) {
  synth::TexelOptions o = small_stack(8, 40);
  Case c(o, false);
  texel::Planes mask{8, 8, {"Y"}, {std::vector<float>(64, 1.f)}};
  mask.values[0][9] = 0;
  texel::write_planes(c.folder.path() / "mask.exr", mask);
  c.stack = texel::open_stack(c.folder.path());
  const texel::Planes maps = c.fit();
  for (std::size_t k = 0; k < 64; ++k) EXPECT_EQ(std::isnan((*maps.find("verdict"))[k]), k == 9);
  EXPECT_EQ(maps::summary_of(maps).fitted, 63u);
}

TEST(Maps, WithoutAFittedTexelHaveNoMedian) {
  Case c(small_stack(4, 40), false);
  texel::write_planes(c.folder.path() / "mask.exr", {4, 4, {"Y"}, {std::vector<float>(16, 0.f)}});
  c.stack = texel::open_stack(c.folder.path());
  const maps::Summary summary = maps::summary_of(c.fit());
  EXPECT_EQ(summary.fitted, 0u);
  EXPECT_FALSE(summary.median_error);
}

TEST(Maps, TakeAMetricByTheNoiseOfSomeTexels) {
  synth::TexelOptions o = small_stack(9, 400);
  o.noise = 0.05;
  Case c(o, false);
  c.settings.options.metric = fit::Metric::automatic;
  const fit::Metric metric = maps::choose_metric(c.stack, c.settings, c.normals());
  EXPECT_NE(metric, fit::Metric::automatic);
  c.settings.options.metric = fit::Metric::cosine_l2;
  EXPECT_EQ(maps::choose_metric(c.stack, c.settings, c.normals()), fit::Metric::cosine_l2);
}

TEST(Maps, RefuseWhatTexelsCannot) {
  maps::Settings s = settings_of(lacquer(), false);
  s.options.loss = fit::Loss::huber;
  EXPECT_THROW(maps::check(s), InputError);
  s.options.loss_scale = 0.1;
  EXPECT_NO_THROW(maps::check(s));
  s.options.free_scale = true;
  EXPECT_THROW(maps::check(s), InputError);
  s.options.free_scale = false;
  s.options.random_starts = 3;
  EXPECT_THROW(maps::check(s), InputError);
}

}  // namespace
}  // namespace brdf
