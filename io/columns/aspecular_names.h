// Reads the names of geometries of multi-angle instruments (ASTM E2194, E2539).
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace brdf::io {

// A geometry in the plane of incidence. `viewer`: the viewing angle in degrees, positive on the mirror side.
struct AspecularGeometry {
  double light = 0, viewer = 0;
  std::string fault;  // the reason against reading this geometry, as the end of a sentence
};

// Reads "45as15": light at 45 degrees, viewer 15 degrees from the mirror direction towards the normal. Also
// reads 45as-15, r45as15, 45a:15, 45/0 (light and viewer). Returns std::nullopt for other names. Geometries
// outside the plane of incidence (45as25az90) and of integrating spheres (d/8) have a fault.
std::optional<AspecularGeometry> aspecular_geometry(std::string_view name);

}  // namespace brdf::io
