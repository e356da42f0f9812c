// One sphere under one directional light, seen from far away, as sphere.glsl draws it.
#pragma once

#include <array>
#include <functional>
#include <optional>

#include "brdf/material.h"

namespace brdf::io::sphere {

// f_r of red, green and blue in 1/sr.
using Colour = std::array<double, 3>;

// f_r of a pair of unit directions in the frame of the surface; std::nullopt if it was not measured. Called
// by several threads at once, as FittedPairs are.
using MeasuredPairs = std::function<std::optional<Colour>(const Vec3<double>& wi, const Vec3<double>& wo)>;

// f_r of a material with colour channels (io/colour/channel_colours.h) or one grey channel.
using FittedPairs = std::function<Colour(const Vec3<double>& wi, const Vec3<double>& wo)>;
// Returns the function of a material; a spectrum is converted to colour. Throws InputError if its channels
// are not colours.
FittedPairs fitted_pairs(const Material& material);

// The light and the viewer in the frame of the sphere. In the initial view of a page, x points to the right
// and y up.
struct View {
  Vec3<double> light, right, up, towards;
};
// Returns the view from the directions of viewer and light: `turn` is the angle about the vertical axis,
// `tilt` the elevation.
View view_from(Angle turn, Angle tilt, Angle light_turn, Angle light_tilt);
// Returns the initial view of a page: the light comes from the upper left, 44.8 degrees from the viewer.
View first_view();

// Returns the frame of the surface at a point of the picture, as for pair_at().
struct Frame {
  Vec3<double> normal, tangent, bitangent;
};
Frame frame_at(const View& view, double x, double y);

// Returns the pair of directions at a point of the picture. The point is in radii from the centre of the
// sphere, at a distance of at most 1. The frame has the normal of the sphere, and its tangent runs along a
// parallel of the sphere. wi points below the horizon on the dark side.
struct Pair {
  Vec3<double> wi, wo;
};
Pair pair_at(const View& view, double x, double y);

}  // namespace brdf::io::sphere
