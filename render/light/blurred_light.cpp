#include "render/light/blurred_light.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "brdf/scalar.h"

namespace brdf::render {
namespace {

// A level without its border: sums of radiance times solid angle, and the solid angle.
struct Level {
  int height;
  std::vector<glm::dvec4> sums;

  explicit Level(int high) : height(high), sums(std::size_t(2 * high) * std::size_t(high), glm::dvec4(0)) {}
  glm::dvec4& at(int x, int y) { return sums[std::size_t(y) * std::size_t(2 * height) + std::size_t(x)]; }
  glm::vec4 mean(int x, int y) {
    const glm::dvec4& sum = at(x, y);
    return glm::vec4(glm::dvec3(sum) / sum.w, 0);
  }
};

// Divides [0, 1] at the borders of two divisions into equal cells. Calls part(cell of the first, cell of the
// second, low, high) for each piece.
template <class Part>
void overlaps(int first, int second, Part part) {
  double low = 0;
  for (int a = 0, b = 0; a < first && b < second;) {
    const double end_a = double(a + 1) / first, end_b = double(b + 1) / second;
    const double high = std::min(end_a, end_b);
    part(a, b, low, high);
    low = high;
    // Integers decide, because equal borders may differ by rounding.
    const std::int64_t left = std::int64_t(a + 1) * second, right = std::int64_t(b + 1) * first;
    a += left <= right;
    b += right <= left;
  }
}

Level finest(const LightMap& light) {
  Level level(kBlurredHeight);
  overlaps(light.height(), level.height, [&](int from_y, int y, double top, double bottom) {
    const double rows = std::cos(kPi * top) - std::cos(kPi * bottom);
    overlaps(light.width(), 2 * level.height, [&](int from_x, int x, double left, double right) {
      const double angle = 2 * kPi * (right - left) * rows;
      level.at(x, y) += glm::dvec4(glm::dvec3(light.texel(from_x, from_y)), 1) * angle;
    });
  });
  return level;
}

Level coarser(Level& fine) {
  Level level(fine.height / 2);
  for (int y = 0; y < fine.height; ++y)
    for (int x = 0; x < 2 * fine.height; ++x) level.at(x / 2, y / 2) += fine.at(x, y);
  return level;
}

// Copies a level into the picture, with its border: the sides wrap around, the poles are repeated.
void place(Level& level, int row, std::vector<glm::vec4>& picture) {
  const int width = 2 * level.height;
  for (int y = -1; y <= level.height; ++y)
    for (int x = -1; x <= width; ++x)
      picture[std::size_t(row + y + 1) * std::size_t(kBlurredPictureWidth) + std::size_t(x + 1)] =
          level.mean((x + width) % width, std::clamp(y, 0, level.height - 1));
}

}  // namespace

std::vector<glm::vec4> blurred_light(const LightMap& light) {
  std::vector<glm::vec4> picture(std::size_t(kBlurredPictureWidth) * std::size_t(kBlurredPictureHeight),
                                 glm::vec4(0));
  Level level = finest(light);
  for (int k = 0; k < kBlurredLevels; ++k) {
    place(level, blurred_row(k), picture);
    if (k + 1 < kBlurredLevels) level = coarser(level);
  }
  return picture;
}

}  // namespace brdf::render
