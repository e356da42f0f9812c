#include "io/samples/phase_angle.h"

#include <algorithm>
#include <cmath>

#include "brdf/angle.h"
#include "io/samples/degrees.h"

namespace brdf::io {

double azimuth_of_phase(double theta_i, double theta_o, double phase) {
  constexpr double kTolerance = 0.5;  // degrees, for angles that were rounded separately
  const double least = std::abs(theta_i - theta_o), most = theta_i + theta_o;
  if (!(phase >= least - kTolerance && phase <= most + kTolerance)) return std::nan("");
  if (theta_i == 0 || theta_o == 0) return 0;
  // The half-angle formulas of the spherical triangle, which are accurate at 0 and at 180 degrees.
  const double sine = sin_degrees((phase + least) / 2) * sin_degrees((phase - least) / 2);
  const double cosine = sin_degrees((most + phase) / 2) * sin_degrees((most - phase) / 2);
  return radians(2 * std::atan2(std::sqrt(std::max(sine, 0.0)), std::sqrt(std::max(cosine, 0.0)))).degrees();
}

}  // namespace brdf::io
