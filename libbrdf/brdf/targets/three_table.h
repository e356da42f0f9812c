// The albedo of a white GGX lobe as approximated by three.js: its texture of 16 x 16 texels with both
// columns added, in ten-thousandths.
// Rows are the cosine of the viewing angle, columns are the roughness. Texel k lies at (k + 0.5)/16; values
// between texels are interpolated linearly. The texture was sampled at these positions. Its largest error
// against the integral is 0.015 in the first rows and 0.003 in the others (tests/libbrdf/targets_test.cpp).
// Source: three 0.187.0 (npm), src/renderers/shaders/DFGLUTData.js.
#pragma once

#include <array>
#include <cstddef>

#include "brdf/scalar.h"

namespace brdf {

inline constexpr std::size_t kThreeSide = 16;
// clang-format off
inline constexpr std::array<int, kThreeSide * kThreeSide> kThreeAlbedo{
    9991, 9531, 8831, 8904, 9124, 9285, 9380, 9436, 9448, 9439, 9402, 9349, 9277, 9194, 9097, 8989,
    10000, 9937, 9583, 9048, 8804, 8813, 8901, 8960, 8964, 8907, 8795, 8641, 8448, 8250, 8044, 7819,
    9998, 9978, 9832, 9463, 9043, 8801, 8713, 8672, 8602, 8475, 8319, 8130, 7889, 7620, 7333, 7030,
    10000, 9988, 9912, 9685, 9319, 8966, 8715, 8528, 8358, 8208, 8003, 7750, 7460, 7142, 6788, 6426,
    9999, 9989, 9941, 9799, 9517, 9159, 8802, 8497, 8266, 8026, 7764, 7465, 7124, 6749, 6352, 5944,
    10001, 9996, 9956, 9861, 9650, 9316, 8918, 8566, 8232, 7923, 7599, 7242, 6851, 6429, 5991, 5540,
    10001, 9997, 9968, 9901, 9736, 9445, 9049, 8650, 8254, 7878, 7485, 7076, 6629, 6167, 5682, 5197,
    9998, 9995, 9974, 9924, 9797, 9533, 9176, 8749, 8305, 7862, 7414, 6940, 6450, 5937, 5418, 4901,
    10002, 9998, 9983, 9936, 9840, 9602, 9278, 8850, 8383, 7877, 7370, 6844, 6303, 5746, 5189, 4643,
    9998, 9999, 9983, 9951, 9861, 9666, 9361, 8946, 8456, 7921, 7356, 6775, 6181, 5581, 4989, 4415,
    9999, 10000, 9987, 9958, 9878, 9713, 9433, 9036, 8532, 7971, 7361, 6727, 6084, 5438, 4810, 4210,
    9998, 9998, 9985, 9964, 9891, 9749, 9495, 9115, 8621, 8026, 7382, 6698, 6005, 5318, 4653, 4030,
    10000, 10000, 9986, 9973, 9903, 9774, 9543, 9179, 8691, 8094, 7409, 6684, 5944, 5209, 4512, 3866,
    10001, 10001, 9991, 9973, 9910, 9795, 9582, 9241, 8764, 8158, 7450, 6682, 5890, 5117, 4386, 3714,
    10000, 10000, 9990, 9976, 9923, 9816, 9616, 9295, 8831, 8221, 7494, 6688, 5857, 5042, 4272, 3578,
    10000, 10000, 9995, 9976, 9932, 9829, 9644, 9342, 8892, 8282, 7540, 6705, 5831, 4972, 4171, 3453,
};
// clang-format on

// Returns the share of each of the 16 texels at a coordinate in 0..1. The end texels extend to the border.
template <class T>
std::array<T, kThreeSide> three_shares(const T& u) {
  const T x = at_most(at_least(u * T(16) - T(0.5), T(0)), T(15));
  std::array<T, kThreeSide> shares;
  for (std::size_t k = 0; k < kThreeSide; ++k) {
    const T away = x - T(double(k));
    shares[k] = at_least(T(1) - larger(away, -away), T(0));
  }
  return shares;
}

template <class S, class G>
S three_white_albedo(const G& cosine, const S& roughness) {
  const auto rows = three_shares(cosine);
  const auto columns = three_shares(roughness);
  S sum(0);
  for (std::size_t c = 0; c < kThreeSide; ++c) {
    G column(0);
    for (std::size_t r = 0; r < kThreeSide; ++r)
      column = column + rows[r] * G(kThreeAlbedo[r * kThreeSide + c] / 10000.0);
    sum = sum + columns[c] * column;
  }
  return sum;
}

}  // namespace brdf
