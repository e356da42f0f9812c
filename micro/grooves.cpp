#include "micro/grooves.h"

#include <cmath>

#include "brdf/scalar.h"

namespace brdf::micro {
namespace {

double beckmann_slope(double alpha, Random& random) {
  return alpha * std::sqrt(-std::log1p(-random.uniform()));
}

// Draws candidates from exp(-t^2/(2 sigma^2)) t, accepted with probability sin t / t.
double oren_nayar_slope(double sigma, Random& random) {
  for (;;) {
    const double angle = sigma * std::sqrt(-2 * std::log1p(-random.uniform()));
    const double accept = random.uniform();
    if (angle > 0 && angle < kPi / 2 && accept * angle < std::sin(angle)) return std::tan(angle);
  }
}

}  // namespace

Surface make_grooves(const Grooves& settings, Random& random) {
  Surface surface;
  surface.nx = 2 * settings.count;
  surface.ny = 1;
  surface.dx = 0.5;
  surface.dy = 16;  // grooves are uniform along y: the period only has to be long compared with their width
  surface.columns_per_frame = 2;
  surface.heights.reserve(surface.nx);
  surface.turns.clear();
  for (int k = 0; k < settings.count; ++k) {
    const double slope = settings.angles == GrooveAngles::beckmann ? beckmann_slope(settings.width, random)
                                                                   : oren_nayar_slope(settings.width, random);
    surface.heights.push_back(0);
    surface.heights.push_back(static_cast<float>(-slope / 2));
    const double azimuth = 2 * kPi * random.uniform();
    surface.turns.push_back({std::cos(azimuth), std::sin(azimuth)});
  }
  surface.find_tops();
  return surface;
}

}  // namespace brdf::micro
