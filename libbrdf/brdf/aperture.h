// Averages of a BRDF over the finite apertures of an instrument.
//
// A detector with full angular width a reads the mean of f_r over its circular cone, which has the solid
// angle 2 pi (1 - cos(a/2)). The same holds for a source. Directions of the cone below the horizon count as
// zero because no light arrives from there.
#pragma once

#include <span>
#include <vector>

#include "brdf/material.h"

namespace brdf {

// A direction of the cone about +z, with its share of the solid angle of the cone. The shares sum to 1.
struct ApertureNode {
  Vec3<double> direction;
  double weight;
};

// Number of rings for fits: 24 nodes, few enough to evaluate in every step of a fit. Accuracy for the peak of
// a Gaussian lobe seen through the cone: 2e-3 if the half width of the lobe at 1/e is a quarter of the width
// of the cone (a lobe half as wide as the aperture), 1e-6 if that half width equals the width of the cone.
inline constexpr int kFitRings = 3;
// Number of rings for synthetic samples: 288 nodes.
inline constexpr int kSynthRings = 12;
inline constexpr int kSynthRingsOfTwo = 5;  // if both source and detector have a width

// Returns a quadrature rule over the cone with this full width (0 to 180 degrees). The rule has `rings`
// Gauss-Legendre points in solid angle between the axis and the edge, and at least 8 azimuthal steps on
// each ring. Neighbouring rings are rotated by half a step. A width of 0 gives one node.
std::vector<ApertureNode> aperture_nodes(Angle full_width, int rings = kFitRings);

// Returns the direction of the node when the axis of the cone is `axis` (a unit vector).
Vec3<double> aperture_direction(const Vec3<double>& axis, const ApertureNode& node);

// Computes f_r per channel averaged over both cones, in 1/sr. `out` has one value per channel.
// Example:
//     using namespace brdf;
//     const Material material = make_material(*find_form("ward"), {"fr"});
//     const auto cone = aperture_nodes(degrees(2)), point = aperture_nodes(degrees(0));
//     double value;
//     const auto wi = direction(30_deg, 0_deg), wo = direction(30_deg, 180_deg);
//     eval_aperture(material, wi, wo, point, cone, {&value, 1});
void eval_aperture(const Material& material, const Vec3<double>& wi, const Vec3<double>& wo,
                   std::span<const ApertureNode> source, std::span<const ApertureNode> detector,
                   std::span<double> out);

}  // namespace brdf
