#include "micro/cavity.h"

#include <algorithm>
#include <cmath>

#include "brdf/directions.h"

namespace brdf::micro {

double groove_single_reflection(double sigma, const Vec& wi, const Vec& wo) {
  constexpr int kAngles = 400, kAzimuths = 720;
  double sum = 0, weights = 0;
  for (int i = 0; i < kAngles; ++i) {
    const double t = (i + 0.5) / kAngles * (kPi / 2);
    const double weight = std::exp(-t * t / (2 * sigma * sigma)) * std::sin(t);
    weights += weight * kAzimuths;
    for (int j = 0; j < kAzimuths; ++j) {
      const Vec a = direction(radians(t), radians((j + 0.5) / kAzimuths * 2 * kPi));
      const double lit = dot(wi, a), seen = dot(wo, a);
      if (lit <= 0 || seen <= 0) continue;
      const double open = std::min({1.0, 2 * wi.z * a.z / lit, 2 * wo.z * a.z / seen});
      sum += weight * open * lit * seen / (kPi * a.z * wi.z * wo.z);
    }
  }
  return sum / weights;
}

}  // namespace brdf::micro
