// How pictures mark what was not measured: stripes of two greys, the same in every picture and shader.
#pragma once

#include <cstddef>

namespace brdf::io {

// Pixels from one stripe to the next along a row; half of them dark. Greys as bytes: neither is a colour of a
// scale.
inline constexpr std::size_t kHatchPeriod = 8;
inline constexpr unsigned char kHatchDark = 89, kHatchBright = 140;

// The grey of a pixel, rows counted from the top.
constexpr unsigned char hatching(std::size_t x, std::size_t y) {
  return (x + y) % kHatchPeriod < kHatchPeriod / 2 ? kHatchDark : kHatchBright;
}

}  // namespace brdf::io
