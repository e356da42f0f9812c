// One sphere under one directional light, seen from far away, as sphere.glsl draws it.
#pragma once

#include <array>
#include <functional>
#include <optional>

#include "brdf/material.h"

namespace brdf::io::sphere {

// f_r of red, green and blue in 1/sr.
using Colour = std::array<double, 3>;

// f_r of a pair of unit directions in the surface's frame; none where it was not measured. Asked by several
// threads at once, as FittedPairs are.
using MeasuredPairs = std::function<std::optional<Colour>(const Vec3<double>& wi, const Vec3<double>& wo)>;

// f_r of a material whose channels are colours (io/colour/channel_colours.h) or one grey.
using FittedPairs = std::function<Colour(const Vec3<double>& wi, const Vec3<double>& wo)>;
FittedPairs fitted_pairs(const Material& material);

// The light and the viewer in the world in which the sphere stands: x to the right and y up as the page
// begins.
struct View {
  Vec3<double> light, right, up, towards;
};
View view_from(Angle turn, Angle tilt, Angle light_turn, Angle light_tilt);
// As a page begins: the light from the upper left, 44.8 degrees from the viewer.
View first_view();

// The pair of directions at a point of the picture, in radii from the sphere's middle, at most 1 from it: in
// the frame whose normal is the sphere's and whose tangent runs along a parallel. wi points below the horizon
// in the dark.
struct Pair {
  Vec3<double> wi, wo;
};
Pair pair_at(const View& view, double x, double y);

}  // namespace brdf::io::sphere
