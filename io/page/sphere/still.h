// Draws still pictures of spheres, for pages without WebGL 2 and for files.
#pragma once

#include <string>

#include "io/page/sphere/view.h"

namespace brdf::io::sphere {

// Draws the fitted material, the measurement and their difference side by side (or only the fitted
// material) from first_view(), as sphere.glsl draws them. Returns a PNG with `side` pixels per sphere,
// transparent around the spheres. `exposure` is in stops; at 0 a white diffuser that faces the light is
// white.
std::string still_picture(const FittedPairs& fitted, const MeasuredPairs& measured, double exposure,
                          int side);

// Returns the same spheres, one PNG each. Without a measurement the last two are empty.
struct Stills {
  std::string fitted, measured, difference;
};
Stills still_pictures(const FittedPairs& fitted, const MeasuredPairs& measured, double exposure, int side);

// Returns the exposure, to half a stop, at which the fitted sphere is neither dark nor white: the brightest
// channel is below 0.8 in nine tenths of the lit pixels.
double exposure_of(const FittedPairs& fitted);

}  // namespace brdf::io::sphere
