// Conversions between degrees and radians that keep the last digit, because the points drawn from a seed
// and the printed commands depend on it. (An Angle multiplies by pi / 180; these functions multiply and
// divide.)
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
