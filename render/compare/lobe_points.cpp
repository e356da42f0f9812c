#include "render/compare/lobe_points.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "io/samples/degrees.h"
#include "io/samples/in_plane.h"

namespace brdf::render {
namespace {

bool was_turned(const io::SampleTable& table) {
  const auto off = [](double phi) { return std::abs(io::sin_degrees(phi)) > io::sin_degrees(kNearLight); };
  return std::ranges::any_of(table.phi_i, off) && !std::ranges::all_of(table.phi_i, off);
}

}  // namespace

std::vector<LobePoint> points_of_light(const io::SampleTable& table, double theta_i) {
  const bool turned = was_turned(table);
  std::vector<LobePoint> out;
  for (std::size_t k = 0; k < table.rows(); ++k) {
    if (std::abs(table.theta_i[k] - theta_i) > kNearLight) continue;
    if (turned && std::abs(io::sin_degrees(table.phi_i[k])) > io::sin_degrees(kNearLight)) continue;
    // Light along the normal has no azimuth; 180 degrees is assumed.
    const double from = table.theta_i[k] > 0 ? table.phi_i[k] : 180;
    out.push_back({table.theta_o[k], std::remainder(table.phi_o[k] - from - 180, 360.0), k});
  }
  return out;
}

std::vector<LobePoint> points_in_plane(const io::SampleTable& table, double theta_i) {
  std::vector<LobePoint> out;
  for (LobePoint point : points_of_light(table, theta_i)) {
    if (!io::is_in_plane(point.theta, point.phi)) continue;
    if (io::cos_degrees(point.phi) < 0) point.theta = -point.theta;
    point.phi = 0;
    out.push_back(point);
  }
  return out;
}

double nearest_light(const io::SampleTable& table, double theta_i) {
  double nearest = std::numeric_limits<double>::quiet_NaN();
  for (const double theta : table.theta_i)
    if (!(std::abs(theta - theta_i) >= std::abs(nearest - theta_i))) nearest = theta;
  return nearest;
}

}  // namespace brdf::render
