// Pictures in memory: measures between two pictures, tone maps, PNG and EXR files.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <string>
#include <vector>

#include "render/scene/scene.h"

namespace brdf::render {

// Linear RGBA, rows from the top. A is 1 for pixels that show a surface, kNotMeasured for a surface without
// a measured reflectance.
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
// Returns a picture from RGBA values, row by row from the top.
Picture picture_from(int width, int height, const std::vector<float>& rgba);

// The bytes of a PNG, before compression.
struct BytePicture {
  int width = 0, height = 0;
  std::vector<std::array<std::uint8_t, 3>> pixels;

  BytePicture() = default;
  BytePicture(int w, int h) : width(w), height(h), pixels(std::size_t(w) * std::size_t(h)) {}
};

struct Difference {
  double rel_mse = 0;  // mean over surface pixels and channels of (a - b)^2 / (b^2 + 0.01)
  // dB, peak 1, both clamped to [0, 1]; infinite if both are equal.
  double psnr = 0;
  double coverage_mismatch = 0;  // share of all pixels that only one of the two covers
  // Share of the surface pixels excluded from these measures because b is not measured there.
  double not_measured = 0;
};
// Returns the measures of the difference between two pictures of the same size.
Difference compare(const Picture& picture, const Picture& reference);

// Returns the display value of a linear colour (scene/display_rule.h).
glm::vec3 tone_mapped(glm::vec3 linear, ToneMap tone_map, float exposure);
// Rounds to the nearest byte or (dithered) up or down by the thresholds of dither.h.
enum class Rounding { nearest, dithered };
BytePicture displayed(const Picture& picture, ToneMap tone_map, float exposure,
                      Rounding rounding = Rounding::nearest);
// Returns the brightest channel of each lit surface pixel, in rising order.
std::vector<double> surface_brightness(const Picture& picture);
// Returns the exposure, in stops and rounded to hundredths, that puts kExposedShare of the lit surface
// below kExposedTo; 0 if no pixel is lit.
constexpr double kExposedShare = 0.95, kExposedTo = 0.7;
float exposure_from(const Picture& picture);
// Returns the share of surface pixels with a channel that the display clips: above 1, or shown as the
// brightest byte.
double clipped_share(const Picture& picture, ToneMap tone_map, float exposure);
// Returns the share of surface pixels with a channel that is not a finite number.
double not_finite_share(const Picture& picture);

// Returns the colour of a relative difference: blue 1e-6 through green and yellow to red 1; black if equal.
glm::vec3 false_color(float relative_difference);
// Returns the colour of a signed difference: blue at -50 % and below, white at 0, red at 50 % and above.
glm::vec3 signed_color(float relative_difference);
constexpr float kMostSigned = 0.5f;
enum class Scale { logarithmic, plus_minus };
// Shows the channel with the largest difference, relative to the reference; hatched for pixels without a
// measured reference.
BytePicture difference_picture(const Picture& picture, const Picture& reference,
                               Scale scale = Scale::logarithmic);

// Returns the left `share` of the first picture and the rest of the second, with a thin line between them.
BytePicture split(const BytePicture& left, const BytePicture& right, float share = 0.5f);

// Returns the bytes of a PNG file.
std::string png_of(const BytePicture& picture);
void write_png(const std::filesystem::path& file, const BytePicture& picture);

// Layers are named name.R, name.G, name.B (and name.A); the unnamed first layer is R, G, B, A.
struct Layer {
  std::string name;
  const Picture* picture;
  bool alpha = false;
};
// Writes the layers, which have the same size, as 32-bit floats.
void write_exr(const std::filesystem::path& file, const std::vector<Layer>& layers);
// Reads a layer of an EXR file. Throws InputError if the file cannot be read or lacks a channel R, G or B
// of this layer.
Picture read_exr(const std::filesystem::path& file, const std::string& layer);

}  // namespace brdf::render
