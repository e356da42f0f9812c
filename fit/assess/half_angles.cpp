#include "fit/assess/half_angles.h"

#include <algorithm>
#include <cmath>

#include "brdf/geometry.h"
#include "io/files/numbers.h"

namespace brdf::fit {

HalfAngles half_angles(const FitData& data, std::size_t row) {
  const Directions<double> d = data.directions(row, 1);
  const Geometry<double> g = geometry(d.wi(0), d.wo(0));
  return {radians(std::atan2(std::hypot(g.h.x, g.h.y), g.h.z)).degrees(),
          radians(std::acos(std::min(g.cos_d, 1.0))).degrees()};
}

void HalfAngleRange::add(const HalfAngles& a) {
  low = {std::min(low.theta_h, a.theta_h), std::min(low.theta_d, a.theta_d)};
  high = {std::max(high.theta_h, a.theta_h), std::max(high.theta_d, a.theta_d)};
}

std::string to_text(const HalfAngleRange& r) {
  const auto part = [](const char* name, double low, double high) {
    return std::string(name) + " " + io::short_number(low, 2) + " to " + io::short_number(high, 2);
  };
  return part("theta_h", r.low.theta_h, r.high.theta_h) + ", " +
         part("theta_d", r.low.theta_d, r.high.theta_d) + " degrees";
}

}  // namespace brdf::fit
