// A sample table as a material: interpolated values where directions fall between its rows.
#pragma once

#include "io/samples.h"
#include "render/reference/reference.h"

namespace brdf::render {

// f_r cos_i of the table: the weighted mean of the nearest rows in half vector and difference vector
// coordinates (the surface taken as isotropic, weights falling with the squared distance, so that a row's own
// directions return its value), in logarithms where the values are positive. Which channels are
// red, green and blue their names say (io/channel_colours.h). Beyond the table's largest polar angle the
// nearest rows stand for the missing ones. Throws InputError where the channels are no colours.
Measured interpolate(const io::SampleTable& table);

}  // namespace brdf::render
