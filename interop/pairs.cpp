#include "interop/pairs.h"

#include <cmath>

namespace brdf::interop {
namespace {

constexpr double kMostTheta = 80;  // degrees

struct Steps {
  std::vector<double> theta_i;  // degrees
  std::vector<double> radii;    // of the half vector's slope, in widths
  double azimuth;               // degrees, where the turns begin
  double theta_o;               // degrees, first of the even grid
};

const Steps& steps_of(Pairs which) {
  static const Steps fitted{{5, 20, 35, 50, 65, 75}, {0, 0.3, 0.6, 1, 1.6, 2.5, 4, 7, 12}, 0, 0};
  static const Steps judged{{0, 12, 28, 42, 58, 72, 80}, {0, 0.45, 0.8, 1.3, 2, 3.2, 5.5, 9}, 12, 6};
  return which == Pairs::fitted ? fitted : judged;
}

void add_mirrored(io::SampleTable& table, double theta_i, double phi_i, const Vec3<double>& half) {
  const Vec3<double> wi = io::unit_vector(theta_i, phi_i);
  const double length = std::sqrt(dot(half, half));
  const Vec3<double> h = half * (1 / length), wo = h * (2 * dot(h, wi)) - wi;
  double theta_o, phi_o;
  io::polar_degrees(wo, theta_o, phi_o);
  if (theta_o <= kMostTheta) table.add_directions(theta_i, phi_i, theta_o, phi_o);
}

}  // namespace

io::SampleTable pairs_about(const Wanted& wanted, Pairs which) {
  const Steps& steps = steps_of(which);
  const Widths widths =
      wanted.lobe < 0 ? Widths() : widths_of(wanted.material.terms[std::size_t(wanted.lobe)]);
  const bool turned = is_anisotropic(wanted.material);
  io::SampleTable table;
  table.channels = wanted.material.channels;
  table.values.resize(table.channels.size());
  table.sigma.resize(table.channels.size());
  // Of an isotropic material half of the circle is enough.
  const double circle = turned ? 360 : 181;
  for (const double turn : turned ? std::vector<double>{0, 45, 90} : std::vector<double>{0})
    for (const double theta_i : steps.theta_i) {
      const double phi_i = turn + (turned ? steps.azimuth : 0);
      for (const double radius : steps.radii)
        for (double phi = steps.azimuth; phi < circle; phi += 45) {
          const double s = (phi + phi_i) * kPi / 180;
          add_mirrored(table, theta_i, phi_i,
                       {radius * widths.along * std::cos(s), radius * widths.across * std::sin(s), 1});
          if (radius == 0) break;
        }
      for (double theta_o = steps.theta_o; theta_o <= kMostTheta; theta_o += 10)
        for (double phi = steps.azimuth; phi < circle; phi += 20)
          table.add_directions(theta_i, phi_i, theta_o, phi_i + phi);
    }
  return table;
}

}  // namespace brdf::interop
