// Uncalibrated measurements: counts, volts, anything that is f_r times a factor that nobody knows.
#pragma once

#include "io/samples/samples.h"

namespace brdf::io {

// Divides values and standard deviations by one factor for the whole table, after which they reflect, in the
// mean over the rows weighted by cos_i cos_o, as much as a white diffuse surface (1/pi) in the brightest
// channel. Shapes and the ratios of weights keep their values. The factor is multiplied into table.scale.
// Throws InputError where no value is above 0.
void make_relative(SampleTable& table);

}  // namespace brdf::io
