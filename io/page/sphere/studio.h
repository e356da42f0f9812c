// A ball in the studio (io/light/studio.h), as still.cpp draws it and as sphere.glsl draws it with the
// functions of studio_glsl().
//
// The light is a sum over rounds of directions, the same for every pixel, so that pictures have no grain.
// A round has a direction to each soft box, one by the cosine, and two by lobes of the material's widths.
// Each direction counts f cos L over the sum of the densities of all six (balance heuristic; Veach and
// Guibas 1995), so that the sum converges for every material; the widths affect only how fast.
#pragma once

#include <array>
#include <string>

#include "brdf/low_discrepancy.h"
#include "brdf/samplers.h"
#include "io/light/studio.h"
#include "io/page/sphere/view.h"

namespace brdf::io::sphere {

inline constexpr int kBoxes = 3, kDirections = 6;  // directions of a round
inline constexpr int kStillRounds = 48;            // of a still picture

// Returns two widths between which the material's lobes lie, estimated from its values for directions of
// incidence near the normal.
std::array<double, 2> lobe_widths(const FittedPairs& fitted);

// Returns the direction of incidence of a lobe of this width, in the frame of the surface, for two numbers
// in [0, 1); and its density per solid angle.
template <class S>
Vec3<S> lobe_direction(const S& width, const S& u1, const S& u2, const Vec3<S>& wo) {
  return mirrored(wo, sample_visible_ggx(Roughness<S>{width, width}, u1, u2, wo));
}
template <class S>
S lobe_density(const S& width, const Vec3<S>& wi, const Vec3<S>& wo) {
  return pdf_visible_ggx(Roughness<S>{width, width}, geometry(wi, wo));
}

// Returns the radiance that a unit ball of the material reflects to a distant viewer, at a place of the
// picture in radii from its middle (see pair_at), with the first kStillRounds rounds.
class Studio {
 public:
  explicit Studio(const Material& material);
  Colour reflected(const View& view, double x, double y) const;

 private:
  Material material_;
  std::array<std::size_t, 3> channels_;
  std::array<double, 2> widths_;
};

// Returns the functions and constants that sphere.glsl needs for the studio, in GLSL ES: studio_radiance(w),
// studio_floor(p, w), studio_boxes(u1, u2), studio_density(w), studio_cosine(u1, u2),
// studio_lobe(width, u1, u2, wo), studio_lobe_density(width, wi, wo), displayed(colour).
std::string studio_glsl();

}  // namespace brdf::io::sphere
