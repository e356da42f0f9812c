// Tests a width that all texels of a region have in common.
#include <gmock/gmock.h>

#include <cstring>

#include "io/files/error.h"
#include "maps/shared_fit.h"
#include "tests/maps/case.h"

namespace brdf {
namespace {

synth::TexelOptions one_width(std::size_t size, double noise) {
  synth::TexelOptions o = small_stack(size, 80);
  o.vary = {{"kd", 0.1, 0.6}};
  o.tilt = 20;
  o.noise = noise;
  return o;
}

struct NoisyCase : Case {
  explicit NoisyCase(std::size_t size) : Case(one_width(size, 0.03), false) {
    settings.options.metric = fit::Metric::log_relative;
  }
};

maps::Sharing whole(const Case& c) {
  return maps::read_sharing({"alpha"}, "", c.stack);
}

texel::Planes fit_shared(const Case& c, const maps::Sharing& sharing, unsigned threads = 1) {
  return maps::fit_shared(c.stack, c.settings, c.normals(), sharing, {std::size_t{1} << 28, threads});
}

double total_cost(const texel::Planes& maps) {
  double sum = 0;
  for (std::size_t k = 0; k < maps.width * maps.height; ++k)
    sum += std::pow(double((*maps.find("error"))[k]), 2) * double((*maps.find("images"))[k]);
  return sum;
}

TEST(Shared, WidthIsTheTruthWithoutNoise) {
  for (const bool fits_normal : {false, true}) {
    const Case c(one_width(8, 0), fits_normal);
    const texel::Planes maps = fit_shared(c, whole(c));
    for (std::size_t k = 0; k < 64; ++k) {
      EXPECT_NEAR(double((*maps.find("alpha_x"))[k]), 0.2, 1e-6);
      const double kd = double((*c.truth.find("kd.g"))[k]);
      EXPECT_NEAR(double((*maps.find("kd.g"))[k]), kd, 1e-6 * kd);
    }
  }
}

TEST(Shared, WidthIsTheMinimumOfAllTexelsTogether) {
  const NoisyCase c(12);
  const texel::Planes maps = fit_shared(c, whole(c)), alone = c.fit();
  const std::vector<float>&alpha = *maps.find("alpha_x"), &error = *maps.find("standard_error.alpha_x");
  EXPECT_THAT(alpha, testing::Each(alpha[0]));
  EXPECT_THAT(error, testing::Each(error[0]));
  EXPECT_EQ(alpha, *maps.find("alpha_y"));
  EXPECT_LT(std::abs(double(alpha[0]) - 0.2), 4 * double(error[0]));
  // The standard error must agree with that of the weighted mean of the separate estimates of all texels.
  double known = 0;
  for (const float e : *alone.find("standard_error.alpha_x"))
    if (e > 0) known += 1 / (double(e) * double(e));
  EXPECT_GT(double(error[0]), 0.7 / std::sqrt(known));
  EXPECT_LT(double(error[0]), 1.4 / std::sqrt(known));
  const auto cost_at = [&](double width) {
    NoisyCase held(12);
    held.settings.options.fix = {{"alpha", {width}}};
    return total_cost(held.fit());
  };
  const double width = double(alpha[0]), step = 0.5 * double(error[0]);
  const double here = cost_at(width), below = cost_at(width - step), above = cost_at(width + step);
  EXPECT_LT(here, below);
  EXPECT_LT(here, above);
  // The parabola through the three costs has its minimum at the width.
  EXPECT_NEAR(0.5 * (below - above) / (below - 2 * here + above), 0, 0.02);
  EXPECT_NEAR(total_cost(maps), here, 1e-6 * here);
}

TEST(Shared, RegionsHaveTheirOwnAndWhatIsInNoneHasItsOwn) {
  const NoisyCase c(16);
  texel::Planes labels{16, 16, {"Y"}, {std::vector<float>(256, 0.f)}};
  for (std::size_t k = 0; k < 256; ++k) labels.values[0][k] = k % 16 < 6 ? 7.f : k % 16 < 12 ? 3.f : 0.f;
  const auto file = c.folder.path() / "truth" / "parts.exr";
  texel::write_planes(file, labels);
  const maps::Sharing sharing = maps::read_sharing({"alpha"}, file, c.stack);
  EXPECT_EQ(sharing.count, 2u);
  const texel::Planes maps = fit_shared(c, sharing), again = fit_shared(c, sharing, 2), alone = c.fit();
  for (std::size_t k = 0; k < maps.values.size(); ++k)
    EXPECT_EQ(0, std::memcmp(maps.values[k].data(), again.values[k].data(), 256 * sizeof(float)));
  const std::vector<float>&alpha = *maps.find("alpha_x"), &own = *alone.find("alpha_x");
  EXPECT_NE(alpha[0], alpha[6]);
  for (std::size_t k = 0; k < 256; ++k) {
    if (k % 16 < 12)
      EXPECT_EQ(alpha[k], alpha[k % 16 < 6 ? 0 : 6]);
    else
      EXPECT_NEAR(double(alpha[k]), double(own[k]), 1e-5 * double(own[k]));
  }
}

TEST(Shared, RefusesWhatIsNoRegionAndNoShape) {
  const Case c(one_width(8, 0), false);
  const auto file = c.folder.path() / "truth" / "parts.exr";
  texel::write_planes(file, {8, 8, {"Y"}, {std::vector<float>(64, 0.5f)}});
  EXPECT_THROW(maps::read_sharing({"alpha"}, file, c.stack), InputError);
  texel::write_planes(file, {8, 4, {"Y"}, {std::vector<float>(32, 1.f)}});
  EXPECT_THROW(maps::read_sharing({"alpha"}, file, c.stack), InputError);
  for (const char* name : {"kd", "warp"})
    EXPECT_THROW(fit_shared(c, maps::read_sharing({name}, "", c.stack)), InputError) << name;
}

}  // namespace
}  // namespace brdf
