// A sample table in place of a material.
#pragma once

#include "brdf/material.h"
#include "io/samples/samples.h"
#include "render/reference/reference.h"

namespace brdf::render {

// f_r cos_i of the table, interpolated (measured/measured.h) beside a fitted material or beside each
// channel's mean, whichever makes the samples likelier; known where the samples are near enough. Which
// channels are red, green and blue their names say (io/colour/channel_colours.h). Throws InputError where the
// channels are no colours.
Measured interpolate(const io::SampleTable& table, const Material* fitted = nullptr);

}  // namespace brdf::render
