// Distant light as a latitude-longitude picture, and random directions in proportion to it.
//
// y is up. The centre of the picture is the direction -z, its right edge is reached by turning to +x, its
// top row is the zenith. The radiance is constant within a texel, which makes the density of sample()
// exact.
#pragma once

#include <cstdint>
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
  // `radiance`: rows from the top; width and height are at least 1.
  LightMap(int width, int height, const std::vector<glm::vec3>& radiance);

  int width() const { return width_; }
  int height() const { return height_; }
  // Radiance (x, y, z), and the density with which the texel's directions are drawn (w).
  const glm::vec4& texel(int x, int y) const { return texels_[std::size_t(y * width_ + x)]; }
  const glm::vec4& texel_towards(const glm::vec3& direction) const;
  // Returns the radiance interpolated between the centres of the texels, for viewing rather than
  // integration.
  glm::vec3 shown(const glm::vec3& direction) const;
  // Returns a direction in proportion to the sum of the texels' channels, from two numbers in [0, 1). The
  // row is drawn from the distribution of rows, the column from the distribution within the row. If the
  // picture is black, directions are uniform.
  LightSample sample(double u1, double u2) const;

  // Data that the shaders search: all texels, and the values of the distributions at the ends of the cells,
  // row by row.
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
// Reads a .hdr or .exr file. Throws InputError naming the file if it is missing, is not such a picture, has
// more than kMostLightTexels texels, or contains a value that is negative or not finite.
inline constexpr std::int64_t kMostLightTexels = 1 << 25;
LightMap load_light_map(const std::filesystem::path& file);

}  // namespace brdf::render
