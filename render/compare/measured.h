// Renders with a sample table in place of a material.
#pragma once

#include "brdf/material.h"
#include "io/samples/samples.h"
#include "render/reference/reference.h"

namespace brdf::render {

// Returns f_r cos_i of the table, interpolated (measured/measured.h) relative to a fitted material or to
// the mean of each channel, whichever gives the samples the higher likelihood. The value is known if
// samples are near enough. The names of the channels determine which are red, green and blue
// (io/colour/channel_colours.h). Throws InputError if the channels are not colours.
Measured interpolate(const io::SampleTable& table, const Material* fitted = nullptr);

}  // namespace brdf::render
