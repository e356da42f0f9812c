#include "interop/pairs.h"

#include <algorithm>
#include <cmath>

#include "interop/loss.h"
#include "io/samples/degrees.h"

namespace brdf::interop {
namespace {

struct Steps {
  std::vector<double> theta_i;  // degrees
  std::vector<double> radii;    // slope of the half vector, in widths
  double azimuth;               // degrees, first azimuth of each turn
  double theta_o;               // degrees, first angle of the even grid
};

const Steps& steps_of(Pairs which) {
  static const Steps fitted{{5, 20, 35, 50, 65, 75}, {0, 0.3, 0.6, 1, 1.6, 2.5, 4, 7, 12}, 0, 0};
  static const Steps judged{{0, 12, 28, 42, 58, 72, 80}, {0, 0.45, 0.8, 1.3, 2, 3.2, 5.5, 9}, 12, 6};
  return which == Pairs::fitted ? fitted : judged;
}

// Half of the circle is enough for an isotropic material.
double circle_of(bool turned) {
  return turned ? 360 : 181;
}

void add_about(io::SampleTable& table, const LobePlace& lobe, const Steps& steps, bool turned) {
  for (const double turn : turned ? std::vector<double>{0, 45, 90} : std::vector<double>{0})
    for (const double theta_i : steps.theta_i) {
      const double from_axis = turn + (turned ? steps.azimuth : 0), phi_i = lobe.tangent + from_axis;
      for (const double radius : steps.radii)
        for (double phi = steps.azimuth; phi < circle_of(turned); phi += 45) {
          const double s = (phi + from_axis) * kPi / 180;
          add_mirrored(table, lobe, theta_i, phi_i, radius * std::cos(s), radius * std::sin(s));
          if (radius == 0) break;
        }
      for (double theta_o = steps.theta_o; theta_o <= kMostTheta; theta_o += 10)
        for (double phi = steps.azimuth; phi < circle_of(turned); phi += 20)
          table.add_directions(theta_i, phi_i, theta_o, phi_i + phi);
    }
}

// Degrees from the mirror direction.
constexpr double kAzimuths[] = {0, 1, 3, 6, 9, 14, 20, 35, 50, 70, 90, 110, 130, 145, 160, 170, 176, 180};
constexpr double kStep = 4;  // step of polar angles, degrees
constexpr double kRadii[] = {0, 0.3, 0.7, 1.2, 2, 3.5};

// Azimuths of incidence in the net, in degrees: along the axes, across the axes and between them.
std::vector<double> light_azimuths(const Material& material) {
  std::vector<double> out;
  if (may_turn(material))
    for (const LobePlace& lobe : lobe_places(material))
      for (const double turn : {0, 45, 90})
        if (std::ranges::find(out, lobe.tangent + turn) == out.end()) out.push_back(lobe.tangent + turn);
  if (out.empty()) out.push_back(0);
  return out;
}

}  // namespace

bool may_turn(const Material& material) {
  const auto outside = [](const Term& term) { return info(term.form).outside; };
  return is_anisotropic(material) || std::ranges::any_of(material.terms, outside);
}

std::vector<LobePlace> lobe_places(const Material& material) {
  std::vector<LobePlace> places;
  for (const Term& term : material.terms)
    if (has_lobe(term)) places.push_back({widths_of(term), term.tangent_phi.degrees()});
  if (places.empty()) places.emplace_back();
  return places;
}

bool add_mirrored(io::SampleTable& table, const LobePlace& lobe, double theta_i, double phi_i, double along,
                  double across) {
  const double c = std::cos(lobe.tangent * kPi / 180), s = std::sin(lobe.tangent * kPi / 180);
  const double x = along * lobe.widths.along, y = across * lobe.widths.across;
  const Vec3<double> wi = io::unit_vector(theta_i, phi_i), half{c * x - s * y, s * x + c * y, 1};
  const Vec3<double> h = half * (1 / std::sqrt(dot(half, half))), wo = h * (2 * dot(h, wi)) - wi;
  const auto [theta_o, phi_o] = io::polar_degrees(wo);
  if (theta_o > kMostTheta) return false;
  table.add_directions(theta_i, phi_i, theta_o, phi_o);
  return true;
}

io::SampleTable pairs_about(const Material& material, Pairs which) {
  io::SampleTable table;
  table.set_channels(material.channels);
  for (const LobePlace& lobe : lobe_places(material))
    add_about(table, lobe, steps_of(which), may_turn(material));
  return table;
}

io::SampleTable values_about(const Material& material, Pairs which) {
  io::SampleTable table = pairs_about(material, which);
  const DirectionArrays<double> arrays = io::unit_directions(table);
  table.values = values_at(material, arrays.view());
  return table;
}

io::SampleTable net_about(const Material& material) {
  io::SampleTable table;
  table.channels = material.channels;
  const bool turned = may_turn(material);
  for (const double phi_i : light_azimuths(material))
    for (double theta_i = 0; theta_i <= kMostTheta; theta_i += kStep) {
      for (double theta_o = 0; theta_o <= kMostTheta; theta_o += kStep)
        for (const double from_mirror : kAzimuths)
          for (const double side :
               turned&& from_mirror > 0 && from_mirror < 180 ? std::vector{1.0, -1.0} : std::vector{1.0})
            table.add_directions(theta_i, phi_i, theta_o, phi_i + 180 + side * from_mirror);
      for (const LobePlace& lobe : lobe_places(material))
        for (const double radius : kRadii)
          for (double turn = 0; turn < 360; turn += 45)
            add_mirrored(table, lobe, theta_i, phi_i, radius * std::cos(turn * kPi / 180),
                         radius * std::sin(turn * kPi / 180));
    }
  return table;
}

}  // namespace brdf::interop
