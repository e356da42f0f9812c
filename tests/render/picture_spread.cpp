// Tests the estimate of noise from pictures.
#include "render/compare/picture_spread.h"

#include <gtest/gtest.h>

#include <cmath>

#include "brdf/random.h"

namespace brdf::render {
namespace {

TEST(PictureSpread, EstimatesTheNoiseOfTheMean) {
  constexpr int kPictures = 64;
  PictureSpread spread(40, 40);
  Random random(3);
  EXPECT_EQ(spread.noise(), -1);
  for (int k = 0; k < kPictures; ++k) {
    Picture picture(40, 40);
    for (std::size_t p = 0; p < picture.pixels.size(); ++p) {
      const float value = 0.5f + 0.2f * float(random.uniform() - 0.5);
      // Half of the picture is background, which does not count although it varies most.
      const bool surface = p % 2 == 0;
      picture.pixels[p] = glm::vec4(glm::vec3(surface ? value : 100 * float(random.uniform())), surface);
    }
    spread.add(picture);
  }
  const double expected = 0.2 / std::sqrt(12.0) / std::sqrt(double(kPictures)) / 0.5;
  EXPECT_NEAR(spread.noise() / expected, 1, 0.05);
}

TEST(PictureSpread, WeightsAMeanByItsPictures) {
  Picture mean(1, 1), more(1, 1);
  mean.pixels[0] = glm::vec4(1, 1, 1, 1);
  more.pixels[0] = glm::vec4(5, 1, 1, 0);
  const Picture all = weighted(mean, 3, more);
  EXPECT_FLOAT_EQ(all.pixels[0].r, 2);
  EXPECT_EQ(all.pixels[0].a, 1);
}

}  // namespace
}  // namespace brdf::render
