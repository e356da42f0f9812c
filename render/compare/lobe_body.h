// A lobe as a body: how far it reaches in a direction is f_r there.
#pragma once

#include <string>

#include "brdf/material.h"
#include "io/samples/samples.h"
#include "render/picture/picture.h"

namespace brdf::render {

// The body of a material's f_r for one direction of the light (towards the left, theta_i from the normal),
// seen from the side and above: its radius is the cube root of f_r over the largest, as in the plot of the
// plane of incidence (lobe_plot.h), of the channel that is largest there; theta_o up to 89 degrees. On the
// ground the angles about the normal and the circle of the largest value; a yellow line to the light, a white
// one in the mirror direction. Coloured as the reflected light where the channels are colours. With a table
// (may be null): the rows that were measured with this light (lobe_points.h) as dots, faint where the body
// hides them; those of an isotropic material on the side towards the eye where most of them are on one.
BytePicture lobe_body_picture(const Material& material, const std::string& name, double theta_i_degrees,
                              const io::SampleTable* measured, int width);

}  // namespace brdf::render
