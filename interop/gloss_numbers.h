// Numbers of glossmeters, for a material, for a lobe's width, and for polished glass.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "brdf/gloss.h"

namespace brdf::interop {

// Names of the numbers, in the order of gloss_numbers().
inline constexpr std::array<std::string_view, 5> kGlossNumbers{kGloss[0].name, kGloss[1].name, kGloss[2].name,
                                                               "haze", "distinctness"};

// A number of one channel.
struct GlossNumber {
  std::string name, channel;
  double value = 0, error_bound = 0;  // of the integration
  std::string rule;                   // the standard, with its geometry
  // Empty if the number is decided; otherwise the reason why it is not. The value is then no result.
  std::string undecided{};
};

// Computes the numbers of every channel, with the plane of incidence at azimuth phi.
std::vector<GlossNumber> gloss_numbers(const Material& material, Angle phi);

// Computes the numbers of polished black glass from Fresnel's reflectance. Throws InputError unless the
// index is in the range 1 to 5; 1 gives no gloss and no distinctness.
std::vector<GlossNumber> gloss_numbers_of_glass(double index);

// Returns the GGX lobe of this width over black, with the exact reflectance of a dielectric.
Material dielectric_lobe(double ggx_alpha, double index);

}  // namespace brdf::interop
