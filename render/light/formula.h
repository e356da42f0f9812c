// Environments defined by formulas: radiance by direction, y upwards.
#pragma once

#include <glm/glm.hpp>

#include "brdf/names.h"

namespace brdf {
namespace render {

// studio: io/light/studio.h, with its floor.
// sky: a clear sky without the sun's disc over a grey ground. uniform: radiance 1 from all directions.
enum class Formula { studio, sky, uniform };

// Returns the radiance from this direction (a unit vector). The luminance distribution of the sky is CIE
// type 12, "clear sky, low illuminance turbidity" (ISO 15469:2004; Darula and Kittler 2002, "CIE general
// sky standard"), normalised to 1 at the zenith. The standard does not define the colour; here it changes
// from blue at the zenith to white at the horizon.
glm::vec3 radiance_of(Formula formula, const glm::vec3& direction);

}  // namespace render

template <>
inline constexpr std::array<std::string_view, 3> kNames<render::Formula>{"studio", "sky", "uniform"};

}  // namespace brdf
