// Resamples a measurement on the grid of a format that other programs read.
#pragma once

#include <memory>

#include "io/samples/samples.h"
#include "measured/measured.h"

namespace brdf::measured {

// Returns f_r at the centres of the MERL cells (io/formats/merl.h), in the channels of the measurement and
// in file order. Only cells for which `measured` is true are returned. Interpolated values below 0 become
// 0. The values come from a lattice and are accurate to about 1 % (tabulated.h). Throws InputError if the
// measurement distinguishes sample rotations, because the cells have no azimuth of the sample.
io::SampleTable at_merl_cells(const std::shared_ptr<const MeasuredReflectance>& measured);

}  // namespace brdf::measured
