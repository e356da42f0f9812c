// Degrees that keep their last digit: what a seed draws and what commands print depends on it. (An Angle
// multiplies by pi / 180, these multiply and divide.)
#pragma once

#include "brdf/scalar.h"

namespace brdf::validate {

constexpr double in_degrees(double radians) {
  return radians * 180 / kPi;
}
constexpr double in_radians(double degrees) {
  return degrees * kPi / 180;
}

}  // namespace brdf::validate
