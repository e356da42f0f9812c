#include "measured/coordinates.h"

#include <algorithm>
#include <cmath>

namespace brdf::measured {

Place place_of(const Vec3<double>& wi, const Vec3<double>& wo, Turning turning, double core) {
  const double x = wi.x + wo.x, y = wi.y + wo.y, z = wi.z + wo.z;
  const double across = std::hypot(x, y), length = std::hypot(across, z);
  const double theta_h = std::atan2(across, z);
  const double dx = wi.x - wo.x, dy = wi.y - wo.y, dz = wi.z - wo.z;
  const double theta_d = std::atan2(std::sqrt(dx * dx + dy * dy + dz * dz), length);
  // n.wi and n.wo are cos theta_h cos theta_d -+ sin theta_h sin theta_d cos phi_d.
  const double sines = std::sin(theta_h) * std::sin(theta_d), half = 0.5 * (wi.z - wo.z);
  const double twice = sines > 0 ? std::min(2 * half * half / sines, 2 * sines) - sines : 0;
  const double t = theta_h / core;
  if (turning == Turning::isotropic) return {0.5 * std::log1p(t * t), theta_d, twice, 0};
  const double q = across > 0 ? std::asinh(t) / across : 0;
  return {q * x, theta_d, twice, q * y};
}

}  // namespace brdf::measured
