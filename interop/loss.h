// What a program's formula loses of a material.
#pragma once

#include <string>

#include "interop/wanted.h"

namespace brdf::interop {

// Relative differences are of f_r + kDark, so that what is black anyway does not count. Where: in the frame of the
// material's wider axis, degrees; phi from the light's azimuth.
inline constexpr double kDark = 1e-3;  // 1/sr

struct Loss {
  double rms = 0;                            // of ln(1 + f cos_i) - ln(1 + g cos_i): what a refit makes least
  double largest = 0, median = 0;            // relative differences
  double theta_i = 0, theta_o = 0, phi = 0;  // of the largest
  double albedo = 0, albedo_theta = 0;       // largest difference of directional albedos, and its angle

  bool exact() const { return largest < 1e-9; }
};

// Of `carried` against the wanted material, on pairs up to 80 degrees that no fit has seen; albedos at 0, 30, 60 and 75.
Loss loss_of(const Wanted& wanted, const Material& carried);

// A lower rms that is paid for by most directions is none: what is bright at grazing light decides the rms, and a picture
// shows the others. The median is at most 2 %, or twice the other's.
bool is_nearer(const Loss& one, const Loss& other);

// "largest 2.1 % (theta_i 80, theta_o 76, phi 180), median 0.03 %, albedo within 0.002 (at 75), rms 0.0012".
std::string in_words(const Loss& loss);

}  // namespace brdf::interop
