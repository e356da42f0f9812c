// Lights and viewers that are not far: where they stand, and what a texel sees of them.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>

#include "brdf/vec3.h"

namespace brdf::texel {

// Distances from the middle of the sample, all lights at one and all viewers at one, and the length of a
// texel's side in the same unit.
struct Rig {
  double light_distance = std::numeric_limits<double>::infinity();
  double viewer_distance = std::numeric_limits<double>::infinity();
  double texel_size = 0;

  bool is_near() const { return std::isfinite(light_distance) || std::isfinite(viewer_distance); }
};

// Lengths whose squares and ratios stay far from the ends of a double.
inline constexpr double kShortest = 1e-9, kLongest = 1e9;

// Whether every length lies between these; distances may be infinite, a texel's side 0.
bool is_in_range(const Rig& rig);

// A texel's middle in the sample's plane: x to the right, y upwards, from the middle of width x height
// texels.
Vec3<double> place_of(const Rig& rig, std::size_t width, std::size_t height, double column, double row);

// From a place in the plane towards what stands at this distance in this unit direction from the sample's
// middle.
Vec3<double> direction_from(const Vec3<double>& place, const Vec3<double>& from_middle, double distance);

// What a point light gives there to a plane that faces it, over what it gives in the sample's middle: the
// square of the ratio of the distances.
double irradiance_at(const Vec3<double>& place, const Vec3<double>& from_middle, double distance);

}  // namespace brdf::texel
