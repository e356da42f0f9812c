// The position of a row in half-vector coordinates: theta_h between the normal and the half vector, theta_d
// between the light and the half vector.
#pragma once

#include <string>

#include "fit/model/data.h"

namespace brdf::fit {

struct HalfAngles {
  double theta_h = 0, theta_d = 0;  // degrees
};
// Returns the half-vector coordinates of a row.
HalfAngles half_angles(const FitData& data, std::size_t row);

struct HalfAngleRange {
  HalfAngles low{90, 90}, high{0, 0};
  // Extends the range to contain `a`.
  void add(const HalfAngles& a);
};
// Returns "theta_h 0 to 4.2, theta_d 10 to 60 degrees".
std::string to_text(const HalfAngleRange& range);

}  // namespace brdf::fit
