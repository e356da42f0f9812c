// Draws a lobe as a body: the radius in each direction shows f_r in this direction.
#pragma once

#include <string>

#include "brdf/material.h"
#include "io/page/body.h"
#include "io/samples/samples.h"
#include "render/picture/picture.h"

namespace brdf::render {

// Draws the body of a material's f_r for one direction of the light (from the left, theta_i_degrees from
// the normal), seen from the side and from above. The radius is the cube root of f_r over the largest f_r,
// as in the plot of the plane of incidence (lobe_plot.h), for the channel that is largest in that
// direction; theta_o runs up to 89 degrees. The ground shows the angles about the normal and the circle of
// the largest value; a yellow line points to the light, a white line in the mirror direction. The body has
// the colour of the reflected light if the channels are colours. If `measured` is not null, the rows that
// were measured with this light (lobe_points.h) are drawn as dots, faint if the body hides them. For an
// isotropic material the dots are mirrored to the side that faces the eye if most of them lie on the other
// side.
// `outer`: the f_r (1/sr) of the outer circle, for several pictures on one scale; 0: the largest value.
// `has_words`: the picture holds its own legend.
BytePicture lobe_body_picture(const Material& material, const std::string& name, double theta_i_degrees,
                              const io::SampleTable* measured, int width, double outer = 0,
                              bool has_words = true);

// Returns the same body for a page whose readers turn it, with one point for every degree of theta_o and
// every 5 degrees of azimuth. `outer` as above.
io::Body lobe_to_turn(const Material& material, double theta_i_degrees, const io::SampleTable* measured,
                      double outer);

// Returns the largest f_r (1/sr) that such a picture shows, of the material and of the measured rows.
double largest_of_lobe(const Material& material, double theta_i_degrees, const io::SampleTable* measured);

}  // namespace brdf::render
