#include <algorithm>
#include <array>

#include "brdf/integrals.h"
#include "fit/assess/assess.h"

namespace brdf::fit {
namespace {

// Degrees. Beyond the last angle, forms approach their limit at grazing incidence.
constexpr std::array kLightAngles{0.0, 10.0, 20.0, 30.0, 40.0, 50.0, 60.0, 70.0, 80.0, 85.0};
constexpr double kAlbedoTolerance = 1e-3;

void take_larger(const LargestAlbedo& a, LargestAlbedo& largest) {
  if (a.value > largest.value) largest = a;
}

}  // namespace

LargestAlbedo albedo_at(const Material& material, double theta) {
  AlbedoOptions options;
  options.tolerance = kAlbedoTolerance;
  std::vector<Angle> azimuths{{}};
  if (is_anisotropic(material)) {
    azimuths.clear();
    for (const Term& term : material.terms)
      for (const Angle turn : {Angle{}, 90_deg}) azimuths.push_back(term.tangent_phi + turn);
  }
  LargestAlbedo largest{0, theta, material.channels[0]};
  for (const Angle phi : azimuths) {
    const std::vector<AlbedoResult> albedo = directional_albedo(material, degrees(theta), phi, options);
    for (std::size_t c = 0; c < albedo.size(); ++c)
      take_larger({albedo[c].value, theta, material.channels[c]}, largest);
  }
  return largest;
}

LargestAlbedos largest_albedos(const Material& material, AngleRange measured) {
  std::vector<double> angles(kLightAngles.begin(), kLightAngles.end());
  angles.insert(angles.end(), {measured.low, measured.high});
  std::ranges::sort(angles);
  LargestAlbedos out{{0, 0, material.channels[0]}, {0, measured.low, material.channels[0]}};
  for (const double theta : angles) {
    const LargestAlbedo a = albedo_at(material, theta);
    take_larger(a, out.anywhere);
    if (theta >= measured.low && theta <= measured.high) take_larger(a, out.measured);
  }
  return out;
}

AngleRange measured_lights(const FitData& data) {
  const auto [low, high] = std::ranges::minmax_element(data.wi_z);
  const auto theta = [](double cosine) { return radians(std::acos(std::clamp(cosine, 0.0, 1.0))).degrees(); };
  return {theta(*high), theta(*low)};
}

}  // namespace brdf::fit
