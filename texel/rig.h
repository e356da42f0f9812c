// The geometry of lights and viewers that are near the sample, as each texel sees them.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>

#include "brdf/vec3.h"

namespace brdf::texel {

// The distances of all lights and of all viewers from the centre of the sample, and the length of a texel's
// side in the same unit.
struct Rig {
  double light_distance = std::numeric_limits<double>::infinity();
  double viewer_distance = std::numeric_limits<double>::infinity();
  double texel_size = 0;

  bool is_near() const { return std::isfinite(light_distance) || std::isfinite(viewer_distance); }
};

// Limits of lengths. Within them squares and ratios stay far from the range limits of a double.
inline constexpr double kShortest = 1e-9, kLongest = 1e9;

// Returns whether every length is within these limits. Distances may also be infinite, and the side of a
// texel may be 0.
bool is_in_range(const Rig& rig);

// Returns the centre of a texel in the plane of the sample: x to the right, y upwards, relative to the
// centre of width x height texels.
Vec3<double> place_of(const Rig& rig, std::size_t width, std::size_t height, double column, double row);

// Returns the unit direction from `place` in the plane to the object that is at `distance` in the unit
// direction `from_middle` from the centre of the sample.
Vec3<double> direction_from(const Vec3<double>& place, const Vec3<double>& from_middle, double distance);

// Returns the irradiance of a point light at `place`, on a plane that faces the light, relative to the
// centre of the sample. This is the square of the ratio of the distances.
double irradiance_at(const Vec3<double>& place, const Vec3<double>& from_middle, double distance);

}  // namespace brdf::texel
