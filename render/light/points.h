// The sample points of environment light. Each pixel has two sequences: one draws directions of the light,
// the other draws directions of the reflectance. Each sequence is the additive recurrence
// (brdf/low_discrepancy.h) from its own start, so that each point is uniformly distributed.
// shaders/points.glsl has the same in GLSL.
#pragma once

#include <array>
#include <cstdint>

#include "brdf/low_discrepancy.h"

namespace brdf::render {

// Number of points drawn at a time. The variance of a pixel's estimate is computed from the variance
// between such runs.
inline constexpr int kRun = 16;

// Two for the light, three for the reflectance.
inline constexpr std::size_t kPointDimensions = 5;
inline constexpr std::array<double, kPointDimensions> kPointSteps = [] {
  const auto light = additive_recurrence_steps<2>();
  const auto own = additive_recurrence_steps<3>();
  return std::array{light[0], light[1], own[0], own[1], own[2]};
}();

// Returns the hash lowbias32 of Wellons, in which each bit of the argument affects the result.
constexpr std::uint32_t mixed_bits(std::uint32_t x) {
  x = (x ^ (x >> 16)) * 0x7feb352du;
  x = (x ^ (x >> 15)) * 0x846ca68bu;
  return x ^ (x >> 16);
}

// Returns the start of each coordinate's sequence in this pixel, in [0, 1).
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
