// Where a row lies by the half vector: theta_h from the normal, theta_d between the light and it.
#pragma once

#include <string>

#include "fit/model/data.h"

namespace brdf::fit {

struct HalfAngles {
  double theta_h = 0, theta_d = 0;  // degrees
};
HalfAngles half_angles(const FitData& data, std::size_t row);

struct HalfAngleRange {
  HalfAngles low{90, 90}, high{0, 0};
  void add(const HalfAngles& a);
};
// "theta_h 0 to 4.2, theta_d 10 to 60 degrees".
std::string to_text(const HalfAngleRange& range);

}  // namespace brdf::fit
