#include <array>

#include "brdf/integrals.h"
#include "fit/assess/assess.h"

namespace brdf::fit {

LargestAlbedo largest_albedo(const Material& material) {
  // Degrees; what a form does beyond is its limit towards grazing.
  constexpr std::array kAngles{0.0, 10.0, 20.0, 30.0, 40.0, 50.0, 60.0, 70.0, 80.0, 85.0};
  AlbedoOptions options;
  options.tolerance = 1e-3;
  std::vector<Angle> azimuths{{}};
  if (is_anisotropic(material)) {
    azimuths.clear();
    for (const Term& term : material.terms)
      for (const Angle turn : {Angle{}, 90_deg}) azimuths.push_back(term.tangent_phi + turn);
  }
  LargestAlbedo largest{0, 0, material.channels[0]};
  for (const double theta : kAngles)
    for (const Angle phi : azimuths) {
      const std::vector<AlbedoResult> albedo = directional_albedo(material, degrees(theta), phi, options);
      for (std::size_t c = 0; c < albedo.size(); ++c)
        if (albedo[c].value > largest.value) largest = {albedo[c].value, theta, material.channels[c]};
    }
  return largest;
}

}  // namespace brdf::fit
