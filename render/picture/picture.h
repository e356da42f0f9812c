// Pictures in memory: measures between two, tone maps, PNG and EXR files.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "render/scene/scene.h"

namespace brdf::render {

// Linear RGBA, rows from the top. A is 1 where there is a surface, kNotMeasured where nobody measured how it
// reflects.
inline constexpr float kNotMeasured = 0.75f;
inline bool is_surface(const glm::vec4& pixel) {
  return pixel.a > 0.5f;
}
inline bool is_measured(const glm::vec4& pixel) {
  return pixel.a > 0.9f;
}
struct Picture {
  int width = 0, height = 0;
  std::vector<glm::vec4> pixels;

  Picture() = default;
  Picture(int w, int h) : width(w), height(h), pixels(std::size_t(w) * std::size_t(h), glm::vec4(0)) {}
  glm::vec4& at(int x, int y) { return pixels[std::size_t(y) * std::size_t(width) + std::size_t(x)]; }
  const glm::vec4& at(int x, int y) const {
    return pixels[std::size_t(y) * std::size_t(width) + std::size_t(x)];
  }
};
Picture picture_from(int width, int height, const std::vector<float>& rgba);

// Bytes as they go into a PNG.
struct BytePicture {
  int width = 0, height = 0;
  std::vector<std::array<std::uint8_t, 3>> pixels;

  BytePicture() = default;
  BytePicture(int w, int h) : width(w), height(h), pixels(std::size_t(w) * std::size_t(h)) {}
};

struct Difference {
  double rel_mse = 0;            // mean over surface pixels and channels of (a - b)^2 / (b^2 + 0.01)
  double psnr = 0;               // dB, peak 1, both clamped to [0, 1]; infinite where equal
  double coverage_mismatch = 0;  // share of all pixels that only one of the two covers
  double not_measured =
      0;  // share of the surface pixels that is left out of these, because b is not measured
};
Difference compare(const Picture& picture, const Picture& reference);

// What the screen shows for a linear colour (scene/display_rule.h).
glm::vec3 tone_mapped(glm::vec3 linear, ToneMap tone_map, float exposure);
// To the nearest byte, or (dithered) up or down by the thresholds of dither.h.
enum class Rounding { nearest, dithered };
BytePicture displayed(const Picture& picture, ToneMap tone_map, float exposure,
                      Rounding rounding = Rounding::nearest);
// The brightest channel of each surface pixel that is lit, in rising order.
std::vector<double> surface_brightness(const Picture& picture);
// Stops that put kExposedShare of the lit surface below kExposedTo, in hundredths; 0 where nothing is lit.
constexpr double kExposedShare = 0.95, kExposedTo = 0.7;
float exposure_from(const Picture& picture);
// Share of surface pixels with a channel that the display clips: above 1, or shown as the brightest byte.
double clipped_share(const Picture& picture, ToneMap tone_map, float exposure);

// Colour of a relative difference: blue 1e-6 through green and yellow to red 1; black where equal.
glm::vec3 false_color(float relative_difference);
// Of a signed one: blue -50 % and below, white 0, red 50 % and above.
glm::vec3 signed_color(float relative_difference);
constexpr float kMostSigned = 0.5f;
enum class Scale { logarithmic, plus_minus };
// The channel that differs most, relative to the reference; hatched where that is not measured.
BytePicture difference_picture(const Picture& picture, const Picture& reference,
                               Scale scale = Scale::logarithmic);

// The left share of one, the rest of the other, with a thin line between.
BytePicture split(const BytePicture& left, const BytePicture& right, float share = 0.5f);

// The bytes of a PNG file.
std::string png_of(const BytePicture& picture);
void write_png(const std::filesystem::path& file, const BytePicture& picture);

// Layers named name.R, name.G, name.B (and name.A); the unnamed first layer is R, G, B, A.
struct Layer {
  std::string name;
  const Picture* picture;
  bool alpha = false;
};
void write_exr(const std::filesystem::path& file, const std::vector<Layer>& layers);
Picture read_exr(const std::filesystem::path& file, const std::string& layer);

}  // namespace brdf::render
