// The hatching for directions without measurements: stripes of two greys, the same in every picture and
// shader.
#pragma once

#include <cstddef>

namespace brdf::io {

// Pixels from one stripe to the next along a row; half of them are dark. The greys are bytes. Neither is a
// colour of a scale.
inline constexpr std::size_t kHatchPeriod = 8;
inline constexpr unsigned char kHatchDark = 89, kHatchBright = 140;

// Returns the grey of a pixel. Rows are counted from the top.
constexpr unsigned char hatching(std::size_t x, std::size_t y) {
  return (x + y) % kHatchPeriod < kHatchPeriod / 2 ? kHatchDark : kHatchBright;
}

}  // namespace brdf::io
