// The points of environment light: for each pixel two sequences of its own, one that draws directions of the
// light and one that draws the reflectance's. Each is the additive recurrence (brdf/low_discrepancy.h) from a
// start of its own, so that every point is evenly distributed. The same in GLSL: shaders/points.glsl.
#pragma once

#include <array>
#include <cstdint>

#include "brdf/low_discrepancy.h"

namespace brdf::render {

// Points that are drawn at a time; the scatter of a pixel's estimate is told from that of such runs.
inline constexpr int kRun = 16;

inline constexpr std::size_t kPointDimensions = 5;  // two for the light, three for the reflectance
inline constexpr std::array<double, kPointDimensions> kPointSteps = [] {
  const auto light = additive_recurrence_steps<2>();
  const auto own = additive_recurrence_steps<3>();
  return std::array{light[0], light[1], own[0], own[1], own[2]};
}();

// Wellons's lowbias32, which every bit of the argument reaches.
constexpr std::uint32_t mixed_bits(std::uint32_t x) {
  x = (x ^ (x >> 16)) * 0x7feb352du;
  x = (x ^ (x >> 15)) * 0x846ca68bu;
  return x ^ (x >> 16);
}

// Where each coordinate's sequence starts in this pixel, in [0, 1).
constexpr std::array<double, kPointDimensions> point_starts(std::uint32_t x, std::uint32_t y,
                                                            std::uint32_t seed) {
  std::array<double, kPointDimensions> starts{};
  const std::uint32_t pixel = mixed_bits(seed + mixed_bits(y + mixed_bits(x)));
  for (std::size_t d = 0; d < kPointDimensions; ++d)
    starts[d] = double(mixed_bits(pixel + std::uint32_t(d) * 0x9e3779b9u) >> 8) * 0x1p-24;
  return starts;
}

inline std::array<double, kPointDimensions> point(const std::array<double, kPointDimensions>& starts,
                                                  std::uint64_t k) {
  std::array<double, kPointDimensions> u{};
  for (std::size_t d = 0; d < kPointDimensions; ++d) u[d] = additive_recurrence(starts[d], kPointSteps[d], k);
  return u;
}

}  // namespace brdf::render
