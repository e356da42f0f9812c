#include "io/in_plane.h"

#include <cmath>
#include <limits>

namespace brdf::io {

double in_plane_angle(const SampleTable& t, std::size_t row) {
  const double turn = std::remainder(t.phi_o[row] - t.phi_i[row], 360.0);
  if (t.theta_o[row] == 0 || std::abs(std::abs(turn) - 180) < 0.5) return t.theta_o[row];
  if (std::abs(turn) < 0.5) return -t.theta_o[row];
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace brdf::io
