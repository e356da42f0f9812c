// Scenes and measures that the quick and the slow tests of environment light share.
#pragma once

#include <algorithm>
#include <cstdio>

#include "io/files/temporary.h"
#include "render/gpu/renderer.h"
#include "tests/libbrdf/widths.h"
#include "tests/render/furnace.h"

namespace brdf::render {

inline FurnaceFindings deferred_furnace(Device& device, const PreparedScene& scene, int pictures,
                                        int samples) {
  Renderer renderer(device, scene, {.gbuffer_bits = 32});
  const auto draw = [&](std::uint32_t seed) {
    renderer.reseed(seed);
    renderer.draw_samples(samples);
    return picture_from(scene.scene.camera.width, scene.scene.camera.height, renderer.read_color());
  };
  return furnace_findings(replicates(pictures, draw), furnace_truth(scene));
}

// A picture that is black except for one texel, with the direction towards this texel and the irradiance of
// a surface that faces it.
struct OnePixelSun {
  std::string file;
  glm::vec3 toward;
  double irradiance;
};
inline OnePixelSun write_one_pixel_sun(const std::filesystem::path& file, int width) {
  const int height = width / 2, x = width * 3 / 10, y = height * 3 / 10;
  Picture picture(width, height);
  picture.at(x, y) = glm::vec4(glm::vec3(1e6f), 1);
  write_exr(file, {{"", &picture}});
  const double theta = kPi * (y + 0.5) / height, phi = 2 * kPi * ((x + 0.5) / width - 0.5);
  const double angle = 2 * kPi / width * (std::cos(kPi * y / height) - std::cos(kPi * (y + 1) / height));
  return {file.string(),
          {float(std::sin(theta) * std::sin(phi)), float(std::cos(theta)),
           float(-std::sin(theta) * std::cos(phi))},
          1e6 * angle};
}

// Returns the largest relative difference of the means of blocks of 8 x 8 pixels. Blocks darker than 1e-3
// of the brightest block are skipped.
inline double worst_block(const Picture& a, const Picture& b) {
  std::vector<std::pair<double, double>> means;
  for (int y = 0; y + 8 <= a.height; y += 8) {
    for (int x = 0; x + 8 <= a.width; x += 8) {
      double sum_a = 0, sum_b = 0;
      for (int k = 0; k < 64; ++k) {
        sum_a += double(a.at(x + k % 8, y + k / 8).g);
        sum_b += double(b.at(x + k % 8, y + k / 8).g);
      }
      means.emplace_back(sum_a, sum_b);
    }
  }
  double brightest = 0, worst = 0;
  for (const auto& [ma, mb] : means) brightest = std::max(brightest, mb);
  for (const auto& [ma, mb] : means)
    if (mb > 1e-3 * brightest) worst = std::max(worst, std::abs(ma / mb - 1));
  return worst;
}

// Writes the sky by formula with a sun of 0.7 degrees radius, 5000 times as bright as the zenith. `width`:
// in pixels.
inline std::string write_sky_with_sun(const std::filesystem::path& file, int width) {
  const int height = width / 2;
  const glm::vec3 sun = glm::normalize(glm::vec3(-0.6f, 0.7f, 0.5f));
  Picture picture(width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double theta = kPi * (y + 0.5) / height, phi = 2 * kPi * ((x + 0.5) / width - 0.5);
      const glm::vec3 w(float(std::sin(theta) * std::sin(phi)), float(std::cos(theta)),
                        float(-std::sin(theta) * std::cos(phi)));
      const float near = glm::dot(w, sun) > std::cos(0.012f) ? 5000.0f : 0;
      picture.at(x, y) = glm::vec4(radiance_of(Formula::sky, w) + near, 1);
    }
  }
  write_exr(file, {{"", &picture}});
  return file.string();
}

// Returns ten materials of ten forms that have a width, with widths from 0.05 to 0.6, anisotropic if the
// form permits. Forms that conserve energy come first, then forms that do not.
inline std::vector<std::pair<std::string, Material>> compared_materials() {
  constexpr std::array kWidths{0.05, 0.1, 0.2, 0.3, 0.45, 0.6};
  std::vector<Reflectance> forms = conserving_forms();
  for (const Reflectance& form : catalogue())
    if (form.info().violates("energy")) forms.push_back(form);
  std::vector<std::pair<std::string, Material>> materials;
  for (const Reflectance& form : forms) {
    Material material = make_material(form);
    const double width = kWidths[materials.size() % kWidths.size()];
    const bool across = form.info().anisotropic();
    if (!set_width(material.terms[0], width, across ? std::min(3 * width, 0.6) : width)) continue;
    char text[64];
    std::snprintf(text, sizeof text, " %.2f%s", width, across ? " and thrice that across" : "");
    materials.emplace_back(std::string(form.info().name) + text, material);
    if (materials.size() == 10) break;
  }
  return materials;
}

// Returns the times of the last run: the passes, their sum, and the share of the shortest pass.
inline std::string times_in_words(const Timestamps& times) {
  double all = 0, least = 1e30;
  std::string text;
  for (const auto& [pass, ms] : times.read()) {
    all += ms;
    least = std::min(least, ms);
    char part[64];
    std::snprintf(part, sizeof part, ", %s %.2f ms", pass.c_str(), ms);
    text += part;
  }
  char part[64];
  std::snprintf(part, sizeof part, "; frame %.2f ms, least pass %.1f %%", all, 100 * least / all);
  return text + part;
}

}  // namespace brdf::render
