// Tests spectra and their conversion to visible colours.
#include "io/colour/spectrum.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "brdf/forms.h"
#include "io/colour/channel_colours.h"
#include "io/colour/in_colour.h"
#include "io/files/error.h"
#include "tests/io/colour_checker.h"

namespace brdf::io {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::vector<double> every(double step, double from, double to) {
  std::vector<double> nm;
  for (double w = from; w <= to; w += step) nm.push_back(w);
  return nm;
}

std::vector<std::string> names_of(const std::vector<double>& wavelengths) {
  std::vector<std::string> names;
  for (const double nm : wavelengths) names.push_back(std::to_string(int(nm)) + "nm");
  return names;
}

TEST(Spectrum, TheColourCheckersColoursAreThePublishedOnes) {
  const auto weights = xyz_weights(every(10, 380, 730), kD50);
  double worst_xy = 0, worst_y = 0;
  for (const CheckerColour& colour : kColourChecker) {
    Tristimulus xyz{};
    for (std::size_t k = 0; k < 36; ++k)
      for (std::size_t c = 0; c < 3; ++c) xyz[c] += weights[k][c] * colour.reflectance[k] / 1000;
    const double sum = xyz[0] + xyz[1] + xyz[2];
    worst_xy = std::max({worst_xy, std::abs(xyz[0] / sum - colour.x), std::abs(xyz[1] / sum - colour.y)});
    worst_y = std::max(worst_y, std::abs(xyz[1] - colour.luminance));
    RecordProperty(colour.name, std::to_string(xyz[1]));
  }
  std::printf("largest difference: x and y %.2g, Y %.2g\n", worst_xy, worst_y);
  EXPECT_LT(worst_xy, 1e-3);
  EXPECT_GT(worst_xy, 5e-4);
  EXPECT_LT(worst_y, 8e-4);
  EXPECT_GT(worst_y, 3e-4);
}

// Tests the tabulated illuminants against the chromaticities that CIE 15 gives for them.
TEST(Spectrum, WhiteHasTheIlluminantsChromaticity) {
  const auto chromaticity = [](double kelvin) {
    const Tristimulus w = xyz_weights(std::vector{500.0}, kelvin)[0];
    EXPECT_NEAR(w[1], 1, 1e-14);
    return std::pair(w[0] / (w[0] + w[1] + w[2]), w[1] / (w[0] + w[1] + w[2]));
  };
  EXPECT_NEAR(chromaticity(kD65).first, 0.31272, 1e-5);
  EXPECT_NEAR(chromaticity(kD65).second, 0.32903, 1e-5);
  EXPECT_NEAR(chromaticity(kD50).first, 0.34567, 1e-5);
  EXPECT_NEAR(chromaticity(kD50).second, 0.35850, 2e-5);
}

TEST(Spectrum, APerfectWhiteIsOneInEveryColourHoweverItWasSampled) {
  for (const auto& nm : {every(10, 400, 700), every(5, 380, 780), std::vector{450.0, 550.0, 650.0}}) {
    Tristimulus sum{};
    for (const Tristimulus& w : srgb_weights(nm))
      for (std::size_t c = 0; c < 3; ++c) sum[c] += w[c];
    for (const double value : sum) EXPECT_NEAR(value, 1, 1e-14);
  }
}

TEST(Spectrum, IsToldByTheNamesOfItsChannels) {
  EXPECT_TRUE(is_spectrum(names_of(every(10, 400, 700))));
  EXPECT_TRUE(is_spectrum({"fr_450nm", "500 nm", "600nm", "650nm", "1064nm"}));
  EXPECT_FALSE(is_spectrum({"465nm", "525nm", "630nm"}));           // three: red, green and blue
  EXPECT_FALSE(is_spectrum({"500nm", "550nm", "600nm", "650nm"}));  // no blue
  EXPECT_FALSE(is_spectrum({"450nm", "550nm", "600nm", "650nm", "nir"}));
  const auto colours = channel_colours(names_of(every(10, 400, 700)));
  ASSERT_TRUE(colours);
  EXPECT_EQ(colours->by, ChannelColours::By::spectrum);
  EXPECT_THAT(colours->note, HasSubstr("31 bands are converted to a colour"));
}

// A material of bands that share a shape equals the sum of its bands in every pair of directions. This
// includes f0.
TEST(InColour, AMaterialIsTheSumOfItsBands) {
  const std::vector<double> nm = every(10, 400, 700);
  const auto weights = srgb_weights(nm);
  for (const char* name : {"lambert", "ward", "cook_torrance"}) {
    Material spectral = make_material(*find_form(name), names_of(nm));
    const ReflectanceInfo& about = info(spectral.terms[0].form);
    for (std::size_t band = 0; band < nm.size(); ++band)
      for (std::size_t k = 0; k < about.weights.size(); ++k)
        spectral.terms[0].weights[band][k] = 0.5 + 0.3 * std::sin(nm[band] / 60 + double(k));
    const Material seen = in_colour(spectral);
    EXPECT_THAT(seen.channels, ElementsAre("r", "g", "b"));
    const Vec3<double> wi{0.6, 0, 0.8}, wo{-0.48, 0.36, 0.8};
    std::vector<double> bands(nm.size()), rgb(3);
    eval(spectral, wi, wo, bands);
    eval(seen, wi, wo, rgb);
    for (std::size_t c = 0; c < 3; ++c) {
      double sum = 0;
      for (std::size_t band = 0; band < bands.size(); ++band) sum += weights[band][c] * bands[band];
      EXPECT_NEAR(rgb[c], sum, 1e-12 * std::abs(sum)) << name << " " << c;
    }
  }
}

TEST(InColour, ATableIsTheSumOfItsBandsAndItsDeviationsAddAsSquares) {
  SampleTable table;
  const std::vector<double> nm{420, 480, 540, 600, 660};
  table.channels = names_of(nm);
  table.add_directions(30, 0, 30, 180);
  table.values = {{1}, {2}, {3}, {4}, {5}};
  table.sigma = {{.1}, {.1}, {.1}, {.1}, {.1}};
  const SampleTable seen = in_colour(table);
  const auto weights = srgb_weights(nm);
  for (std::size_t c = 0; c < 3; ++c) {
    double sum = 0, squares = 0;
    for (std::size_t b = 0; b < 5; ++b) {
      sum += weights[b][c] * double(b + 1);
      squares += weights[b][c] * weights[b][c] * .01;
    }
    EXPECT_NEAR(seen.values[c][0], sum, 1e-14);
    EXPECT_NEAR(seen.sigma[c][0], std::sqrt(squares), 1e-14);
  }
  EXPECT_EQ(in_colour(seen).channels, seen.channels);  // colours are unchanged
}

}  // namespace
}  // namespace brdf::io
