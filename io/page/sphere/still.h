// Draws still pictures of spheres, for pages without WebGL 2 and for files. All use the neutral tone map
// (io/colour/neutral.h).
#pragma once

#include <string>

#include "io/page/sphere/view.h"

namespace brdf::io::sphere {

// Draws a material in the studio (studio.h) from first_view(). Returns a PNG with `side` pixels,
// transparent around the ball, and the same with half the pixels across. Takes 40 microseconds per pixel of
// one core. Throws InputError if the channels are not colours.
struct StudioPictures {
  std::string whole, half;
};
StudioPictures studio_pictures(const Material& material, double exposure, int side);
// Returns the exposure in stops at which the studio shows the material: 0, except if nine tenths of the ball
// would be darker than 1/64 or brighter than 4 times white. In that case the brightest channel of nine
// tenths of the ball is below 0.8, to half a stop.
double studio_exposure(const Material& material);

// Draws the fitted material, the measurement and their difference side by side (or only the fitted
// material) from first_view(), as sphere.glsl draws them, under the single light of
// view.h. Returns a PNG with `side` pixels per sphere,
// transparent around the spheres. `exposure` is in stops; at 0 a white diffuser that faces the light is
// white.
std::string still_picture(const FittedPairs& fitted, const MeasuredPairs& measured, double exposure,
                          int side);

// Returns the same spheres, one PNG each. Without a measurement the last two are empty. `range`:
// difference_range().
struct Stills {
  std::string fitted, measured, difference;
  double range = 0.5;
};
Stills still_pictures(const FittedPairs& fitted, const MeasuredPairs& measured, double exposure, int side);

// Returns the relative difference at the ends of the colour scale, from 0.01 to 0.5: the smallest step of 1,
// 2, 5, 10, 20 and 50 % that 19 of 20 measured points of first_view() do not exceed. 0.5 without a
// measurement.
double difference_range(const FittedPairs& fitted, const MeasuredPairs& measured);

// Returns the exposure, to half a stop, at which the fitted sphere is neither dark nor white: the brightest
// channel is below 0.8 in nine tenths of the lit pixels.
double exposure_of(const FittedPairs& fitted);

}  // namespace brdf::io::sphere
