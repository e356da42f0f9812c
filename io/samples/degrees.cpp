#include "io/samples/degrees.h"

#include <array>
#include <cmath>

namespace brdf::io {
namespace {

// Taylor series on [-pi/4, pi/4] in s = x^2, highest power first. The first omitted term is below 1e-17.
constexpr std::array kSine{
    1.0 / 355687428096000.0, -1.0 / 1307674368000.0, 1.0 / 6227020800.0, -1.0 / 39916800.0,
    1.0 / 362880.0,          -1.0 / 5040.0,          1.0 / 120.0,        -1.0 / 6.0};
constexpr std::array kCosine{
    1.0 / 20922789888000.0, -1.0 / 87178291200.0, 1.0 / 479001600.0, -1.0 / 3628800.0,
    1.0 / 40320.0,          -1.0 / 720.0,         1.0 / 24.0,        -0.5};

double series(const std::array<double, 8>& coefficients, double s) {
  double sum = 0;
  for (const double c : coefficients) sum = sum * s + c;
  return sum;
}
double sin_series(double x) {
  const double s = x * x;
  return x + x * (s * series(kSine, s));
}
double cos_series(double x) {
  const double s = x * x;
  return 1.0 + s * series(kCosine, s);
}

double sin_quadrants(double degrees, int shift) {
  const double quarter = std::nearbyint(degrees / 90.0);
  const double x = (degrees - 90.0 * quarter) * (kPi / 180);
  switch ((static_cast<long long>(quarter) + shift) & 3) {
    case 0:
      return sin_series(x);
    case 1:
      return cos_series(x);
    case 2:
      return -sin_series(x);
    default:
      return -cos_series(x);
  }
}

}  // namespace

double sin_degrees(double degrees) {
  return sin_quadrants(degrees, 0);
}

double cos_degrees(double degrees) {
  return sin_quadrants(degrees, 1);
}

double within_turn(double phi) {
  const double rest = std::fmod(phi, 360.0), turned = rest < 0 ? rest + 360 : rest;
  return turned < 360 ? turned + 0.0 : 0.0;  // a tiny negative angle rounds to 360; + 0 turns -0 into 0
}

Vec3<double> unit_vector(double theta, double phi) {
  const double sin_theta = sin_degrees(theta);
  return {sin_theta * cos_degrees(phi), sin_theta * sin_degrees(phi), cos_degrees(theta)};
}

Polar polar_degrees(const Vec3<double>& w) {
  const double theta = radians(std::atan2(std::sqrt(w.x * w.x + w.y * w.y), w.z)).degrees();
  const double phi = radians(std::atan2(w.y, w.x)).degrees();
  return {theta, within_turn(phi)};
}

}  // namespace brdf::io
