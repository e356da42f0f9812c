// The steps from linear light to a picture for display: samples, tone map, exposure, rounding, backdrop.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <random>
#include <set>

#include "brdf/reflectance.h"
#include "io/material/material_file.h"
#include "render/compare/supersample.h"
#include "render/picture/dither.h"
#include "render/picture/picture.h"
#include "render/reference/reference.h"

namespace brdf::render {
namespace {

Scene sphere(const Material& material, int size) {
  Scene scene = material_scene({{"m", material}});
  scene.camera.width = scene.camera.height = size;
  return scene;
}

Picture traced(const PreparedScene& scene) {
  return render_reference(scene);
}

TEST(Supersample, PlacesFillCellsColumnsAndRowsAndTheirMeanIsTheCentre) {
  for (const int n : {1, 2, 4, 5}) {
    std::set<int> cells, columns, rows;
    glm::dvec2 sum(0);
    for (const glm::vec2& p : sample_places(n)) {
      const double x = double(p.x) + 0.5, y = double(p.y) + 0.5;
      cells.insert(int(x * n) + n * int(y * n));
      columns.insert(int(x * n * n));
      rows.insert(int(y * n * n));
      sum += glm::dvec2(p);
    }
    EXPECT_EQ(cells.size(), std::size_t(n * n));
    EXPECT_EQ(columns.size(), std::size_t(n * n));
    EXPECT_EQ(rows.size(), std::size_t(n * n));
    EXPECT_NEAR(glm::length(sum), 0, 1e-5);
  }
}

TEST(Supersample, AnOffsetOfOnePixelIsThePictureMovedByOne) {
  Scene scene = sphere(make_material(*find_form("oren_nayar")), 48);
  const Picture there = render_reference(prepare(scene));
  scene.camera.offset = {1, 2};
  const Picture moved = render_reference(prepare(scene));
  int apart = 0;
  for (int y = 0; y < 46; ++y)
    for (int x = 0; x < 47; ++x) apart += glm::distance(moved.at(x, y), there.at(x + 1, y + 2)) > 1e-3f;
  EXPECT_LE(apart, 2);  // an edge may pass through a pixel's centre
  EXPECT_GT(glm::distance(there.at(24, 24), there.at(25, 26)), 1e-3f);
}

// Returns the root mean square difference of the pictures after tone mapping, over the pixels at an edge of
// the object.
double edge_error(const Picture& picture, const Picture& truth, const Scene& scene) {
  double sum = 0;
  int count = 0;
  for (int y = 1; y + 1 < truth.height; ++y) {
    for (int x = 1; x + 1 < truth.width; ++x) {
      int covered = 0;
      for (int k = 0; k < 9; ++k) covered += is_surface(truth.at(x + k % 3 - 1, y + k / 3 - 1));
      if (covered == 0 || covered == 9) continue;
      const glm::vec3 d = tone_mapped(glm::vec3(picture.at(x, y)), scene.tone_map, 0) -
                          tone_mapped(glm::vec3(truth.at(x, y)), scene.tone_map, 0);
      sum += double(glm::dot(d, d)) / 3;
      ++count;
    }
  }
  return std::sqrt(sum / count);
}

TEST(Supersample, EdgesComeNearTheTruthOf64Samples) {
  const Scene scene = sphere(make_material(*find_form("cook_torrance")), 128);
  const PreparedScene prepared = prepare(scene);
  const Picture truth = supersampled(prepared, 8, traced);
  const double one = edge_error(traced(prepared), truth, scene),
               sixteen = edge_error(supersampled(prepared, 4, traced), truth, scene);
  RecordProperty("one", std::to_string(one));
  RecordProperty("sixteen", std::to_string(sixteen));
  EXPECT_GT(one, 0.06);  // measured: 0.083
  EXPECT_LT(one, 0.11);
  EXPECT_GT(sixteen, 0.007);  // measured: 0.011
  EXPECT_LT(sixteen, 0.015);
}

TEST(Supersample, WhatMostSamplesSayIsWhatThePixelIs) {
  const PreparedScene scene = prepare(sphere(make_material(*find_form("lambert")), 4));
  int call = 0;
  const Picture mean = supersampled(scene, 2, [&](const PreparedScene&) {
    Picture picture(4, 4);
    picture.pixels[0] = glm::vec4(float(call), 0, 0, 1);                     // covered in all samples
    picture.pixels[1] = glm::vec4(1, 1, 1, call < 2 ? 1.0f : 0.0f);          // in half of the samples
    picture.pixels[2] = glm::vec4(1, 1, 1, call < 1 ? 1.0f : 0.0f);          // in a quarter of the samples
    picture.pixels[3] = glm::vec4(1, 1, 1, call < 1 ? 1.0f : kNotMeasured);  // not measured in most samples
    ++call;
    return picture;
  });
  EXPECT_EQ(call, 4);
  EXPECT_EQ(mean.pixels[0], glm::vec4(1.5f, 0, 0, 1));
  EXPECT_EQ(mean.pixels[1].a, 1);
  EXPECT_EQ(mean.pixels[2].a, 0);
  EXPECT_EQ(mean.pixels[3].a, kNotMeasured);
}

TEST(Dither, EveryThresholdOnceAndLowFrequenciesAreMissing) {
  const std::vector<float> tile = void_and_cluster(1);
  constexpr int n = kDitherTile;
  ASSERT_EQ(tile.size(), std::size_t(n * n));
  std::vector<float> sorted = tile;
  std::sort(sorted.begin(), sorted.end());
  for (int k = 0; k < n * n; ++k) ASSERT_FLOAT_EQ(sorted[std::size_t(k)], (float(k) + 0.5f) / (n * n));
  // Power by frequency. White noise has n^2/12 at every frequency.
  double low = 0, high = 0;
  int lows = 0, highs = 0;
  for (int v = -n / 2; v < n / 2; ++v) {
    for (int u = -n / 2; u < n / 2; ++u) {
      std::complex<double> sum = 0;
      for (int k = 0; k < n * n; ++k)
        sum +=
            double(tile[std::size_t(k)]) * std::polar(1.0, -2 * kPi * double(u * (k % n) + v * (k / n)) / n);
      const double radius = std::hypot(u, v), power = std::norm(sum) / (n * n / 12.0);
      if (radius > 0 && radius < 5) low += power, ++lows;
      if (radius > 10) high += power, ++highs;
    }
  }
  EXPECT_LT(low / lows, 0.01);
  EXPECT_GT(high / highs, 1.2);
  EXPECT_NE(void_and_cluster(2), tile);
  EXPECT_EQ(void_and_cluster(1), tile);
}

TEST(Dither, TheMeanIsTheValueAndBlackAndWhiteStay) {
  Picture picture(kDitherTile, kDitherTile);
  for (const float value : {0.0f, 0.3f, 100.25f / 255, 1.0f}) {
    for (glm::vec4& p : picture.pixels) p = glm::vec4(value, value, value, 1);
    double sum = 0;
    for (const auto& p : displayed(picture, ToneMap::none, 0, Rounding::dithered).pixels) {
      EXPECT_LE(std::abs(p[0] - 255 * value), 1);
      EXPECT_EQ(p[0], p[2]);  // grey stays grey
      sum += p[0];
    }
    EXPECT_NEAR(sum / double(picture.pixels.size()), 255 * double(value), 1e-3);
    const auto nearest = displayed(picture, ToneMap::none, 0);
    EXPECT_EQ(int(nearest.pixels[5][1]), int(std::lround(255 * double(value))));
  }
}

// The formula of the Khronos specification, step by step.
glm::vec3 khronos_neutral(glm::vec3 color) {
  const float start = 0.8f - 0.04f, desaturation = 0.15f;
  const float x = std::min(color.r, std::min(color.g, color.b));
  const float offset = x < 0.08f ? x - 6.25f * x * x : 0.04f;
  color -= offset;
  const float peak = std::max(color.r, std::max(color.g, color.b));
  if (peak < start) return color;
  const float d = 1 - start;
  const float new_peak = 1 - d * d / (peak + d - start);
  color *= new_peak / peak;
  const float g = 1 - 1 / (desaturation * (peak - new_peak) + 1);
  return glm::mix(color, glm::vec3(new_peak), g);
}

float decoded(float x) {
  return x <= 0.04045f ? x / 12.92f : std::pow((x + 0.055f) / 1.055f, 2.4f);
}

// Returns the angle on the colour circle as a ratio of differences.
float hue_ratio(const glm::vec3& c) {
  const float high = std::max({c.r, c.g, c.b}), low = std::min({c.r, c.g, c.b});
  return (c.r + c.g + c.b - high - low - low) / (high - low);
}

TEST(ToneMap, NeutralIsTheSpecificationsAndKeepsTheHue) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> stops(-6, 6);
  float worst_reinhard = 0;
  for (int k = 0; k < 2000; ++k) {
    const glm::vec3 c(std::exp2(stops(random)), std::exp2(stops(random)), std::exp2(stops(random)));
    const glm::vec3 shown = tone_mapped(c, ToneMap::neutral, 0), expected = khronos_neutral(c);
    const glm::vec3 linear(decoded(shown.r), decoded(shown.g), decoded(shown.b));
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(linear[i], expected[i], 2e-6);
      EXPECT_GE(shown[i], 0);
      EXPECT_LE(shown[i], 1);
    }
    const float most =
        std::max({expected.r, expected.g, expected.b}) - std::min({expected.r, expected.g, expected.b});
    if (most < 0.01f) continue;
    EXPECT_NEAR(hue_ratio(linear), hue_ratio(c), 1e-3);
    const glm::vec3 bleached = c / (c + 1.0f);
    worst_reinhard = std::max(worst_reinhard, std::abs(hue_ratio(bleached) - hue_ratio(c)));
  }
  EXPECT_GT(worst_reinhard, 0.3f);  // c/(1+c) of each channel does not preserve hue
}

TEST(ToneMap, CoppersHighlightStaysCopper) {
  const glm::vec3 highlight = 4.0f * glm::vec3(0.95f, 0.64f, 0.54f);
  const auto saturation = [](ToneMap map, const glm::vec3& c) {
    const glm::vec3 s = tone_mapped(c, map, 0);
    return 1 - std::min({s.r, s.g, s.b}) / std::max({s.r, s.g, s.b});
  };
  EXPECT_GT(saturation(ToneMap::neutral, highlight), 1.5f * saturation(ToneMap::reinhard, highlight));
}

TEST(Exposure, PutsTheLitSurfaceBelowItsMark) {
  Picture picture(100, 10);
  for (std::size_t k = 0; k < 1000; ++k)
    picture.pixels[k] = glm::vec4(0.001f * float(k), 0, 0.01f, k < 990 ? 1.0f : 0.0f);
  const float stops = exposure_from(picture);
  int below = 0;
  for (std::size_t k = 0; k < 990; ++k)
    below += double(std::max(picture.pixels[k].r, picture.pixels[k].b)) * std::exp2(double(stops)) <=
             kExposedTo * 1.01;
  EXPECT_NEAR(below / 990.0, kExposedShare, 0.015);
  EXPECT_EQ(stops, exposure_from(picture));
  for (glm::vec4& p : picture.pixels) p *= glm::vec4(0.25f, 0.25f, 0.25f, 1);
  EXPECT_NEAR(exposure_from(picture), stops + 2, 0.011);
  EXPECT_EQ(exposure_from(Picture(3, 3)), 0);
}

// Returns the share of the silhouette at which the object, after tone mapping, differs from the pixel next
// to it by less than 12 of 255, so that figure and ground merge.
double merged_share(const Material& material) {
  const Scene scene = sphere(material, 160);
  const Picture picture = render_reference(prepare(scene));
  int edge = 0, merged = 0;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 1; x + 1 < picture.width; ++x) {
      if (!is_surface(picture.at(x, y))) continue;
      for (const int side : {-1, 1}) {
        if (is_surface(picture.at(x + side, y))) continue;
        const glm::vec3 apart = tone_mapped(glm::vec3(picture.at(x, y)), scene.tone_map, 0) -
                                tone_mapped(glm::vec3(picture.at(x + side, y)), scene.tone_map, 0);
        ++edge;
        merged += std::max({std::abs(apart.r), std::abs(apart.g), std::abs(apart.b)}) < 12.0f / 255;
      }
    }
  }
  return double(merged) / edge;
}

TEST(Backdrop, NoObjectOfOneBrightnessMergesWithIt) {
  double worst = 0;
  const auto check = [&](const Material& material, const std::string& name) {
    const double share = merged_share(material);
    worst = std::max(worst, share);
    EXPECT_LT(share, 0.15) << name;
  };
  for (const char* name : {"rolled_brass", "ivory_plastic", "glossy_grey_paper"})
    check(io::read_material(std::string(BRDF_SOURCE_DIR "/data/materials/") + name + ".json"), name);
  for (const double rho : {0.02, 0.05, 0.1, 0.2, 0.4, 0.8}) {
    Material paint = make_material(*find_form("lambert"));
    for (auto& channel : paint.terms[0].weights) channel = {rho};
    check(paint, "rho " + std::to_string(rho));
  }
  EXPECT_GT(worst, 0);  // a gradient contains every grey at some point
}

}  // namespace
}  // namespace brdf::render
