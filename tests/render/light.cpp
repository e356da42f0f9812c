// Environment light: sampling densities, orientation, the sky formula, picture files, and the white furnace
// of the reference.
#include "render/light/blurred_light.h"
#include "render/light/light_map.h"

#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <set>

#include "brdf/random.h"
#include "io/files/error.h"
#include "io/files/temporary.h"
#include "render/light/points.h"
#include "render/picture/picture.h"
#include "tests/render/furnace.h"

namespace brdf::render {
namespace {

double solid_angle(const LightMap& map, int y) {
  const auto cosine = [&](int row) { return std::cos(kPi * double(row) / double(map.height())); };
  return 2 * kPi / double(map.width()) * (cosine(y) - cosine(y + 1));
}

// Returns a map with bright and dark texels that differ by a factor of up to 1000; a fifth of the texels
// are black.
LightMap random_map(int width, int height) {
  Random random(7);
  std::vector<glm::vec3> radiance;
  for (int k = 0; k < width * height; ++k) {
    const auto l = float(k % 5 == 0 ? 0 : random.log_uniform(0.01, 10));
    radiance.emplace_back(l, 0.5f * l, 2 * l);
  }
  return {width, height, radiance};
}

TEST(LightMap, DensityIntegratesToOne) {
  for (const LightMap& map : {random_map(16, 8), random_map(3, 50), light_map_of(Formula::studio),
                              light_map_of(Formula::sky), light_map_of(Formula::uniform)}) {
    double sum = 0;
    for (int y = 0; y < map.height(); ++y)
      for (int x = 0; x < map.width(); ++x) sum += double(map.texel(x, y).a) * solid_angle(map, y);
    EXPECT_NEAR(sum, 1, 1e-5) << map.width();
  }
}

TEST(LightMap, SamplesFallIntoTexelsByTheirDensity) {
  const LightMap map = random_map(12, 7);
  constexpr int kDraws = 200000;
  std::vector<int> counts(12 * 7);
  Random random(11);
  for (int k = 0; k < kDraws; ++k) {
    const LightSample s = map.sample(random.uniform(), random.uniform());
    EXPECT_NEAR(glm::length(s.direction), 1, 1e-5);
    const glm::vec4& texel = map.texel_towards(s.direction);
    counts[std::size_t(&texel - map.texels().data())]++;
  }
  double chi2 = 0;
  int cells = 0;
  for (std::size_t k = 0; k < counts.size(); ++k) {
    const double expected = kDraws * double(map.texels()[k].a) * solid_angle(map, int(k) / 12);
    if (expected < 5) {
      EXPECT_LE(counts[k], 20) << k;
      continue;
    }
    chi2 += (counts[k] - expected) * (counts[k] - expected) / expected;
    ++cells;
  }
  EXPECT_GT(cells, 50);
  // Wilson and Hilferty's approximation: chi2 lies within 4 standard deviations of its mean, on both sides.
  const double z =
      (std::cbrt(chi2 / (cells - 1)) - 1 + 2.0 / 9 / (cells - 1)) / std::sqrt(2.0 / 9 / (cells - 1));
  EXPECT_LT(std::abs(z), 4) << chi2 << " over " << cells;
}

TEST(LightMap, SamplesWithinATexelAreEvenInSolidAngle) {
  const LightMap map(1, 1, {glm::vec3(1)});
  Random random(3);
  glm::dvec3 mean(0), squares(0);
  constexpr int kDraws = 100000;
  for (int k = 0; k < kDraws; ++k) {
    const glm::dvec3 w(map.sample(random.uniform(), random.uniform()).direction);
    mean += w / double(kDraws);
    squares += w * w / double(kDraws);
  }
  for (int c = 0; c < 3; ++c) {
    EXPECT_NEAR(mean[c], 0, 0.01);
    EXPECT_NEAR(squares[c], 1.0 / 3, 0.01);
  }
  EXPECT_NEAR(map.texel(0, 0).a, 1 / (4 * kPi), 1e-7);
}

TEST(LightMap, ABlackPictureIsDrawnFromEvenly) {
  const LightMap map(4, 3, std::vector<glm::vec3>(12, glm::vec3(0)));
  for (const glm::vec4& texel : map.texels()) EXPECT_NEAR(texel.a, 1 / (4 * kPi), 1e-6);
}

TEST(LightMap, TheCentreIsAheadAndTheRightEdgeIsBehind) {
  std::vector<glm::vec3> radiance;
  for (int k = 0; k < 8 * 4; ++k) radiance.emplace_back(float(k));
  const LightMap map(8, 4, radiance);
  const auto at = [&](const glm::vec3& w) { return int(map.texel_towards(glm::normalize(w)).r); };
  EXPECT_EQ(at({0.01f, 0.01f, -1}), 8 + 4);
  EXPECT_EQ(at({-0.01f, -0.01f, -1}), 16 + 3);
  EXPECT_EQ(at({1, 0.01f, -0.01f}), 8 + 5);
  EXPECT_EQ(at({0.01f, 0.01f, 1}), 8 + 7);
  EXPECT_EQ(at({0.01f, 1, -0.01f}), 5);
  // Half way between the centres of texels the displayed colour is their mean.
  EXPECT_NEAR(map.shown(glm::normalize(glm::vec3(0, 0, -1))).r, (11 + 12 + 19 + 20) / 4.0, 1e-3);
}

TEST(Environment, RotationTurnsCounterClockwiseFromAbove) {
  const glm::vec3 ahead = to_picture({"uniform", 90}) * glm::vec3(-1, 0, 0);
  EXPECT_NEAR(ahead.z, -1, 1e-6);  // the direction ahead is now to the left
}

TEST(Formula, TheSkyHasTheStandardsRatios) {
  // CIE type 12: a -1, b -0.32, c 10, d -3, e 0.45. The formula is computed independently of the library's
  // code for a sun at the zenith distance s.
  const glm::vec3 sun = glm::normalize(glm::vec3(-0.6f, 0.7f, 0.5f));
  const double s = std::acos(double(sun.y));
  const auto f = [](double chi) {
    return 1 + 10 * (std::exp(-3 * chi) - std::exp(-1.5 * kPi)) + 0.45 * std::pow(std::cos(chi), 2);
  };
  const auto sum = [](const glm::vec3& v) { return double(v.r + v.g + v.b); };
  EXPECT_NEAR(sum(radiance_of(Formula::sky, {0, 1, 0})), 3, 1e-5);
  const double toward = f(0) * (1 - std::exp(-0.32 / std::cos(s))) / (f(s) * (1 - std::exp(-0.32)));
  EXPECT_NEAR(sum(radiance_of(Formula::sky, sun)), 3 * toward, 1e-3);
  EXPECT_EQ(radiance_of(Formula::uniform, {1, 0, 0}), glm::vec3(1));
}

std::string refusal(const std::filesystem::path& file) {
  try {
    load_light_map(file);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(BlurredLight, EachLevelKeepsTheMeanOverTheSphereAndItsBorder) {
  const LightMap light = light_map_of(Formula::studio);
  const auto mean_of = [](int width, int height, auto texel) {
    glm::dvec3 sum(0);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        sum += glm::dvec3(texel(x, y)) * (std::cos(kPi * y / height) - std::cos(kPi * (y + 1) / height)) /
               double(2 * width);
    return sum;
  };
  const glm::dvec3 wanted =
      mean_of(light.width(), light.height(), [&](int x, int y) { return glm::vec3(light.texel(x, y)); });
  const std::vector<glm::vec4> picture = blurred_light(light);
  for (int level = 0; level < kBlurredLevels; ++level) {
    const int height = kBlurredHeight >> level, width = 2 * height;
    const auto at = [&](int x, int y) {
      return glm::vec3(picture[std::size_t((blurred_row(level) + y + 1) * kBlurredPictureWidth + x + 1)]);
    };
    const glm::dvec3 mean = mean_of(width, height, at);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(mean[c], wanted[c], 1e-5 * wanted[c]) << level;
    for (int y = 0; y < height; ++y) {
      EXPECT_EQ(at(-1, y), at(width - 1, y)) << level;
      EXPECT_EQ(at(width, y), at(0, y)) << level;
    }
    EXPECT_EQ(at(0, -1), at(0, 0));
    EXPECT_EQ(at(0, height), at(0, height - 1));
  }
}

TEST(LightMap, ReadsRadianceAndOpenExrPictures) {
  const io::TemporaryFolder folder;
  const std::filesystem::path hdr = folder.path() / "a.hdr", exr = folder.path() / "a.exr";
  // Mantissas divided by 256, times 2^(exponent - 128).
  std::ofstream(hdr, std::ios::binary) << "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n"
                                       << std::string("\x80\x40\x20\x81\x80\x80\x80\x88", 8);
  const LightMap from_hdr = load_light_map(hdr);
  ASSERT_EQ(from_hdr.width(), 2);
  EXPECT_NEAR(from_hdr.texel(0, 0).r, 1, 0.01);
  EXPECT_NEAR(from_hdr.texel(0, 0).g, 0.5, 0.01);
  EXPECT_NEAR(from_hdr.texel(1, 0).b, 128, 1);
  Picture picture(2, 3);
  picture.at(1, 2) = {1, 2, 1e6f, 1};
  write_exr(exr, {{"", &picture, true}});
  const LightMap from_exr = load_light_map(exr);
  EXPECT_EQ(glm::vec3(from_exr.texel(1, 2)), glm::vec3(1, 2, 1e6f));
  picture.at(0, 1).g = -1;
  write_exr(exr, {{"", &picture, true}});
  EXPECT_NE(refusal(exr).find("the pixel (0, 1) has the value -1"), std::string::npos) << refusal(exr);
}

TEST(LightMap, GoesByTheContentNotByTheName) {
  const io::TemporaryFolder folder;
  const std::filesystem::path exr = folder.path() / "a.exr", named_hdr = folder.path() / "b.hdr",
                              hdr = folder.path() / "c";
  Picture picture(2, 3);
  picture.at(1, 2) = {1, 2, 3, 1};
  write_exr(exr, {{"", &picture, true}});
  std::filesystem::rename(exr, named_hdr);
  EXPECT_EQ(glm::vec3(load_light_map(named_hdr).texel(1, 2)), glm::vec3(1, 2, 3));
  std::ofstream(hdr, std::ios::binary) << "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n"
                                       << std::string("\x80\x40\x20\x81\x80\x80\x80\x88", 8);
  EXPECT_NEAR(load_light_map(hdr).texel(0, 0).r, 1, 0.01);
}

TEST(LightMap, RefusesWhatIsNoPicture) {
  const io::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "a.exr", other = folder.path() / "a.png";
  EXPECT_NE(refusal(file).find("no such file; an environment is a .hdr"), std::string::npos);
  std::ofstream(file) << "text";
  EXPECT_NE(refusal(file).find("neither a Radiance picture (.hdr) nor"), std::string::npos) << refusal(file);
  std::ofstream(other, std::ios::binary) << "\x76\x2f\x31\x01 and no more";
  EXPECT_NE(refusal(other).find("not a readable OpenEXR picture"), std::string::npos) << refusal(other);
  std::ofstream(folder.path() / "a.hdr") << "#?RADIANCE\nand no more\n";
  EXPECT_NE(refusal(folder.path() / "a.hdr").find("not a readable Radiance picture"), std::string::npos);
  std::ofstream(folder.path() / "cut.hdr", std::ios::binary)
      << "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n\x80\x40\x20\x81\x80\x80\x80";
  EXPECT_NE(refusal(folder.path() / "cut.hdr").find("is truncated"), std::string::npos);
}

TEST(Points, FillTheirDimensionsEvenly) {
  const auto starts = point_starts(3, 5, 1);
  EXPECT_NE(starts, point_starts(4, 5, 1));
  EXPECT_NE(starts, point_starts(3, 5, 2));
  for (std::size_t d = 0; d < kPointDimensions; ++d) {
    std::array<int, 16> counts{};
    for (std::uint64_t k = 0; k < 1600; ++k) counts[std::size_t(16 * point(starts, k)[d])]++;
    for (const int count : counts) EXPECT_NEAR(count, 100, 5);
  }
}

// The light's starts are those of the place in a square, and squares are shifted by different numbers.
TEST(Points, TheStartsOfTheLightRepeatInShiftedSquares) {
  std::set<std::array<std::uint32_t, 2>> shifts;
  for (std::uint32_t square = 0; square < 50; ++square) {
    std::set<std::array<double, kLightDimensions>> starts;
    for (std::uint32_t x = 0; x < kLightSquare; ++x) {
      const auto here = point_starts(square * kLightSquare + x, 7, 3);
      starts.insert({here[0], here[1]});
    }
    EXPECT_EQ(starts.size(), kLightSquare);
    shifts.insert(light_place(square * kLightSquare, 0, 3));
  }
  EXPECT_GT(shifts.size(), 45u);
  for (std::uint32_t x = 0; x < kLightSquare; ++x) {  // the pixel of the second square with the same place
    const auto place = light_place(x, 7, 3), origin = light_place(kLightSquare, 0, 3);
    const std::uint32_t across = (place[0] + kLightSquare - origin[0]) % kLightSquare;
    const std::uint32_t down = (place[1] + kLightSquare - origin[1]) % kLightSquare;
    const auto a = point_starts(x, 7, 3), b = point_starts(kLightSquare + across, down, 3);
    for (std::size_t d = 0; d < kPointDimensions; ++d) EXPECT_EQ(a[d] == b[d], d < kLightDimensions);
  }
}

// The bound of the standard error is 5 % here. The slow test requires a standard error of 0.5 % in every
// pixel.
TEST(Reference, UniformLightShowsTheAlbedoOfEveryConservingForm) {
  const std::vector<Reflectance> forms = conserving_forms();
  EXPECT_GE(forms.size(), 8u);
  WhiteFurnace furnace(0.05);
  for (const Reflectance& form : forms)
    furnace.add(std::string(form.info().name),
                reference_furnace(sphere_in(make_material(form), "uniform"), 32, 16));
}

}  // namespace
}  // namespace brdf::render
