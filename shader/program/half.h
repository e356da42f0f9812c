// Rounding to half precision (IEEE 754 binary16).
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace brdf::shader {

inline constexpr float kLargestHalf = 65504;         // larger numbers from 65520 are rounded to infinity
inline constexpr float kLeastNormalHalf = 0x1p-14f;  // smaller numbers are multiples of 2^-24

// Returns the nearest number of half precision, of two nearest numbers the even one. Subnormal numbers are
// kept, as the IEEE standard requires; a device may replace them by 0.
inline float rounded_to_half(float x) {
  constexpr float kOverflow = 65520;
  constexpr std::uint32_t kDropped = 13;  // bits of the significand that half precision does not have
  const float size = std::fabs(x);
  // The sum has a spacing of 2^-24.
  const float subnormal = (size + 0.5f) - 0.5f;
  const auto bits = std::bit_cast<std::uint32_t>(size);
  const std::uint32_t even = (bits >> kDropped & 1) + (1u << (kDropped - 1)) - 1;
  const auto normal = std::bit_cast<float>((bits + even) >> kDropped << kDropped);
  const float rounded = size < kLeastNormalHalf ? subnormal
                        : size < kOverflow      ? normal
                        : x != x                ? x
                                                : std::numeric_limits<float>::infinity();
  return std::copysign(rounded, x);
}

// Returns the number that these bits of half precision represent.
inline float half_of_bits(std::uint16_t bits) {
  const int exponent = bits >> 10 & 31, significand = bits & 1023;
  const float size = exponent == 31  ? significand == 0 ? std::numeric_limits<float>::infinity()
                                                        : std::numeric_limits<float>::quiet_NaN()
                      : exponent == 0 ? std::ldexp(float(significand), -24)
                                     : std::ldexp(float(significand + 1024), exponent - 25);
  return std::copysign(size, bits >> 15 ? -1.0f : 1.0f);
}

}  // namespace brdf::shader
