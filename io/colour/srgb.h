// The sRGB encoding of light, for numbers and for the scalar that generates shaders.
#pragma once

#include <cmath>

#include "brdf/math.h"

namespace brdf::io {

// Power functions that every scalar provides in addition to its arithmetic.
inline float to_power(float x, float exponent) {
  return std::pow(x, exponent);
}
inline double to_power(double x, double exponent) {
  return std::pow(x, exponent);
}

// Encodes one linear channel in [0, 1] (IEC 61966-2-1).
template <class S>
S srgb_encoded(const S& x) {
  const S curve = S(1.055) * to_power(x, S(1) / S(2.4)) - S(0.055);
  return select(S(0.0031308) < x, curve, S(12.92) * x);
}

// Decodes one channel in [0, 1]: the inverse of srgb_encoded().
inline double srgb_decoded(double x) {
  return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
}

}  // namespace brdf::io
