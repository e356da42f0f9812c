// Light from far away as a latitude-longitude picture, and random directions in proportion to it.
//
// y is up. The picture's centre is the direction -z, its right edge is reached by turning to +x, its top row
// is the zenith. A texel's radiance is the same all over it, so that the density of sample() is exact.
#pragma once

#include <filesystem>
#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "render/light/formula.h"

namespace brdf::render {

struct LightSample {
  glm::vec3 direction;  // unit vector to the light
  glm::vec3 radiance;
  float density;  // of the direction per solid angle, 1/sr
};

class LightMap {
 public:
  // Radiances, rows from the top; width and height at least 1.
  LightMap(int width, int height, const std::vector<glm::vec3>& radiance);

  int width() const { return width_; }
  int height() const { return height_; }
  // Radiance, and the density with which its directions are drawn.
  const glm::vec4& texel(int x, int y) const { return texels_[std::size_t(y * width_ + x)]; }
  const glm::vec4& texel_towards(const glm::vec3& direction) const;
  // Interpolated between the texels' centres: for what is looked at rather than integrated.
  glm::vec3 shown(const glm::vec3& direction) const;
  // A direction in proportion to the sum of the texels' channels, for two numbers in [0, 1): by the
  // distribution of rows and that of columns within a row. Everywhere alike where the picture is black.
  LightSample sample(double u1, double u2) const;

  // What the shaders search: all texels, and the distributions' values at the ends of the cells, row by row.
  std::span<const glm::vec4> texels() const { return texels_; }
  std::span<const float> columns() const { return columns_; }
  std::span<const float> rows() const { return rows_; }

 private:
  glm::vec2 place_of(const glm::vec3& direction) const;  // in texels from the upper left corner

  int width_, height_;
  std::vector<glm::vec4> texels_;
  std::vector<float> columns_, rows_;
};

LightMap light_map_of(Formula formula);
// A .hdr or .exr file. Throws InputError naming the file where it is missing, no such picture, has more than
// kMostLightTexels or a value that is negative or not finite.
inline constexpr std::int64_t kMostLightTexels = 1 << 25;
LightMap load_light_map(const std::filesystem::path& file);

}  // namespace brdf::render
