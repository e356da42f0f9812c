// Averages over an instrument's finite apertures.
//
// A detector of full angular width a reads the mean of f_r over its circular cone of solid angle 2 pi (1
// - cos(a/2)); so does a source. Directions of the cone below the horizon count as zero: they are dark.
#pragma once

#include <span>
#include <vector>

#include "brdf/material.h"

namespace brdf {

// A direction of the cone about +z, with its share of the cone's solid angle; the shares sum to 1.
struct ApertureNode {
  Vec3<double> direction;
  double weight;
};

// Cheap enough to fit with: 24 nodes. Seen through it, the peak of a Gaussian
// lobe whose half width at 1/e is a quarter of the cone's width (a lobe half
// as wide as the aperture) is right to 2e-3, at the cone's own width to 1e-6.
inline constexpr int kFitRings = 3;
// For synthetic samples: 288 nodes.
inline constexpr int kSynthRings = 12;
inline constexpr int kSynthRingsOfTwo = 5;  // where source and detector both have a width

// Quadrature over the cone of this full width (0 to 180 degrees): `rings` Gauss-Legendre points in solid
// angle between axis and edge, at least 8 steps of azimuth on each, neighbouring rings turned by half a step.
// Width 0 gives one node.
std::vector<ApertureNode> aperture_nodes(Angle full_width, int rings = kFitRings);

// The node's direction when the cone's axis is `axis` (a unit vector).
Vec3<double> aperture_direction(const Vec3<double>& axis, const ApertureNode& node);

// f_r per channel averaged over both cones, in 1/sr. `out` has one value per channel.
void eval_aperture(const Material& material, const Vec3<double>& wi, const Vec3<double>& wo,
                   std::span<const ApertureNode> source, std::span<const ApertureNode> detector,
                   std::span<double> out);

}  // namespace brdf
