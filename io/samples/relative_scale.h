// Scales uncalibrated measurements: counts, volts or any quantity that is f_r times an unknown factor.
#pragma once

#include "io/samples/samples.h"

namespace brdf::io {

// Divides values and standard deviations by one factor for the whole table. Afterwards the brightest
// channel reflects as much as a white diffuse surface (1/pi), in the mean over the rows weighted by cos_i
// cos_o. Shapes and ratios of weights do not change. The factor is multiplied into table.scale. Throws
// InputError if no channel has a weighted mean above 0.
// Example:
//     // #include "brdf/io/formats/read.h"
//     brdf::io::SampleTable counts = brdf::io::read_samples("paint.csv");
//     make_relative(counts);
//     std::printf("the values were divided by %g\n", counts.scale);
void make_relative(SampleTable& table);

}  // namespace brdf::io
