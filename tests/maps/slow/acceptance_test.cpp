// Tests a stack of 256 x 256 texels and 151 images: the parameters found, the coverage of their standard
// errors, and the picture.
#include <gtest/gtest.h>

#include "tests/maps/case.h"

namespace brdf {
namespace {

constexpr std::size_t kSize = 256;

TEST(MapsOf65536Texels, WithoutNoiseAreTheTruthUnderGivenNormals) {
  expect_truth(kSize, false, 2);
}

TEST(MapsOf65536Texels, WithoutNoiseAreTheTruthWhereNormalsAreFitted) {
  expect_truth(kSize, true, 2);
}

TEST(MapsOf65536Texels, StandardErrorsCoverTheTruth) {
  expect_coverage(kSize, 0.92, 2);
}

TEST(MapsOf65536Texels, GiveThePictureUnderAnotherLight) {
  synth::TexelOptions o = small_stack(kSize, 151);
  o.noise = 0.03;
  for (const bool fits_normal : {false, true}) {
    const Case c(o, fits_normal);
    const double decibels = psnr(c, c.fit(std::size_t{1} << 28, 2));
    std::cout << "normals " << (fits_normal ? "fitted" : "given") << ": " << decibels << " dB\n";
    EXPECT_GT(decibels, 40);
  }
}

}  // namespace
}  // namespace brdf
