// Environments made by formula: radiance by direction, y upwards.
#pragma once

#include <glm/glm.hpp>

#include "brdf/names.h"

namespace brdf {
namespace render {

// studio: three soft boxes on a dim wall, the largest at the upper left of who looks along -z. sky: a clear
// sky without the sun's disc over a grey ground. uniform: radiance 1 from everywhere.
enum class Formula { studio, sky, uniform };

// The radiance that comes from this direction (a unit vector). The sky's distribution is the CIE's type 12,
// "clear sky, low illuminance turbidity" (ISO 15469:2004; Darula and Kittler 2002, "CIE general sky
// standard"), 1 at the zenith; its colour is not part of that and goes from blue at the zenith to white at
// the horizon.
glm::vec3 radiance_of(Formula formula, const glm::vec3& direction);

}  // namespace render

template <>
inline constexpr std::array<std::string_view, 3> kNames<render::Formula>{"studio", "sky", "uniform"};

}  // namespace brdf
