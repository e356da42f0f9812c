// The sample points of environment light. Each pixel has two sequences: one draws directions of the light,
// the other draws directions of the reflectance. Each sequence is the additive recurrence
// (brdf/low_discrepancy.h) from its own start, so that each point is uniformly distributed. The starts of the
// light's sequences repeat in squares of pixels, so that the renderer finds the light's directions once for
// all squares; each square is shifted by a random number of pixels, which hides the repetition.
// shaders/points.glsl has the same in GLSL.
#pragma once

#include <array>
#include <cstdint>

#include "brdf/low_discrepancy.h"

namespace brdf::render {

// Number of points drawn at a time. The variance of a pixel's estimate is computed from the variance
// between such runs.
inline constexpr int kRun = 16;

// Width of the squares in pixels.
inline constexpr std::uint32_t kLightSquare = 64;

// Two for the light, three for the reflectance.
inline constexpr std::size_t kLightDimensions = 2, kPointDimensions = 5;
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

// Returns the start of a coordinate's sequence, in [0, 1), where the hash of the pixel is `bits`.
constexpr double point_start(std::uint32_t bits, std::size_t dimension) {
  return double(mixed_bits(bits + std::uint32_t(dimension) * 0x9e3779b9u) >> 8) * 0x1p-24;
}
constexpr std::uint32_t pixel_bits(std::uint32_t x, std::uint32_t y, std::uint32_t seed) {
  return mixed_bits(seed + mixed_bits(y + mixed_bits(x)));
}

// Returns the place of a pixel in its shifted square.
constexpr std::array<std::uint32_t, 2> light_place(std::uint32_t x, std::uint32_t y, std::uint32_t seed) {
  const std::uint32_t shift = pixel_bits(x / kLightSquare, y / kLightSquare, seed);
  return {(x + shift) % kLightSquare, (y + (shift >> 16)) % kLightSquare};
}

// Returns the starts of all coordinates in this pixel.
constexpr std::array<double, kPointDimensions> point_starts(std::uint32_t x, std::uint32_t y,
                                                            std::uint32_t seed) {
  const auto [place_x, place_y] = light_place(x, y, seed);
  const std::uint32_t of_light = pixel_bits(place_x, place_y, seed), own = pixel_bits(x, y, seed);
  std::array<double, kPointDimensions> starts{};
  for (std::size_t d = 0; d < kPointDimensions; ++d)
    starts[d] = point_start(d < kLightDimensions ? of_light : own, d);
  return starts;
}

inline std::array<double, kPointDimensions> point(const std::array<double, kPointDimensions>& starts,
                                                  std::uint64_t k) {
  std::array<double, kPointDimensions> u{};
  for (std::size_t d = 0; d < kPointDimensions; ++d) u[d] = additive_recurrence(starts[d], kPointSteps[d], k);
  return u;
}

}  // namespace brdf::render
