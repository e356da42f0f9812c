#include "io/samples/set_points.h"

#include <cmath>

#include "brdf/angle.h"

namespace brdf::io {

double degrees_of_printed_radians(double number) {
  constexpr double kPerDegree = 1000, kRounding = 3e-5;
  const double angle = radians(number).degrees();
  const double near = std::round(angle * kPerDegree) / kPerDegree + 0.0;  // + 0 turns -0 into 0
  return std::abs(angle - near) <= kRounding ? near : angle;
}

}  // namespace brdf::io
