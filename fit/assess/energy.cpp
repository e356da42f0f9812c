#include "brdf/integrals.h"
#include "fit/assess/assess.h"

namespace brdf::fit {

LargestAlbedo largest_albedo(const Material& material) {
  constexpr double kStep = 5, kLast = 85;  // degrees; what a form does beyond is its limit towards grazing
  AlbedoOptions options;
  options.tolerance = 1e-3;
  std::vector<Angle> azimuths{{}};
  if (is_anisotropic(material)) {
    azimuths.clear();
    for (const Term& term : material.terms)
      for (const Angle turn : {Angle{}, 90_deg}) azimuths.push_back(term.tangent_phi + turn);
  }
  LargestAlbedo largest{0, 0, material.channels[0]};
  for (double theta = 0; theta <= kLast; theta += kStep)
    for (const Angle phi : azimuths) {
      const std::vector<AlbedoResult> albedo = directional_albedo(material, degrees(theta), phi, options);
      for (std::size_t c = 0; c < albedo.size(); ++c)
        if (albedo[c].value > largest.value) largest = {albedo[c].value, theta, material.channels[c]};
    }
  return largest;
}

}  // namespace brdf::fit
