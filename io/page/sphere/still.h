// The pictures of spheres where nothing can be turned: in a page without WebGL 2, and in files.
#pragma once

#include <string>

#include "io/page/sphere/view.h"

namespace brdf::io::sphere {

// Fitted, measured and difference beside each other (or the fitted one alone) from first_view(), as
// sphere.glsl draws them: a PNG of `side` pixels a sphere, transparent beside them. `exposure` in stops; at 0
// a white diffuser that faces the light is white.
std::string still_picture(const FittedPairs& fitted, const MeasuredPairs& measured, double exposure,
                          int side);

// The same, a PNG each; without a measurement the last two are empty.
struct Stills {
  std::string fitted, measured, difference;
};
Stills still_pictures(const FittedPairs& fitted, const MeasuredPairs& measured, double exposure, int side);

// The exposure, to half a stop, at which the fitted sphere is neither dark nor white: the brightest channel
// of nine tenths of its lit pixels is below 0.8.
double exposure_of(const FittedPairs& fitted);

}  // namespace brdf::io::sphere
