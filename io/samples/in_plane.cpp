#include "io/samples/in_plane.h"

#include <cmath>
#include <limits>

#include "io/samples/degrees.h"

namespace brdf::io {

bool is_in_plane(double theta_o, double turn) {
  return std::abs(sin_degrees(theta_o) * sin_degrees(turn)) <= sin_degrees(kInPlane);
}

double in_plane_angle(const SampleTable& t, std::size_t row) {
  const double turn = t.phi_o[row] - t.phi_i[row];
  if (!is_in_plane(t.theta_o[row], turn)) return std::numeric_limits<double>::quiet_NaN();
  return cos_degrees(turn) > 0 && t.theta_o[row] > 0 ? -t.theta_o[row] : t.theta_o[row];
}

}  // namespace brdf::io
