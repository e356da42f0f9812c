// Integrals over half vectors for factors that are not forms, by the midpoint rule in the slopes, scaled by
// a width. The relative error is about 1e-6 for smooth integrands and 1e-4 if the horizon cuts the lobe.
#pragma once

#include <cmath>

#include "brdf/geometry.h"

namespace brdf {

// Returns the integral of f(h) over the solid angle of the normalised half vector h. `width`: scale of the
// slopes.
template <class F>
double integral_over_half_vectors(double width, F&& f) {
  constexpr int kRadii = 1200, kTurns = 240;
  double sum = 0;
  for (int i = 0; i < kRadii; ++i) {
    const double u = (i + 0.5) / kRadii;
    const double slope = width * u / (1 - u), step = width / ((1 - u) * (1 - u) * kRadii);
    const double cos_h = 1 / std::sqrt(1 + slope * slope);
    for (int j = 0; j < kTurns; ++j) {
      const double phi = 2 * kPi * (j + 0.5) / kTurns;
      const Vec3<double> h{slope * std::cos(phi) * cos_h, slope * std::sin(phi) * cos_h, cos_h};
      sum += f(h) * cos_h * cos_h * cos_h * slope * step * (2 * kPi / kTurns);
    }
  }
  return sum;
}

// Returns the integral of f(wi, wo, h) cos_i over wi for a lobe about the half vector. `width`: scale of
// the slopes.
template <class F>
double half_vector_albedo(double width, const Vec3<double>& wo, F&& f) {
  return integral_over_half_vectors(width, [&](const Vec3<double>& h) {
    const double oh = dot(wo, h);
    const Vec3<double> wi = h * (2 * oh) - wo;
    return oh <= 0 || wi.z <= 0 ? 0 : f(wi, wo, h) * wi.z * 4 * oh;
  });
}

}  // namespace brdf
