// A measurement on the lattice of a format that other programs read.
#pragma once

#include <memory>

#include "io/samples/samples.h"
#include "measured/measured.h"

namespace brdf::measured {

// f_r at the centres of the MERL cells (io/formats/merl.h) in the measurement's channels, in file order: only
// where `measured` is true, and 0 where interpolation falls below it. Values are kept on a lattice, within
// about 1 % (tabulated.h). Throws InputError where the samples were turned, as those cells know no azimuth of
// the sample.
io::SampleTable at_merl_cells(const std::shared_ptr<const MeasuredReflectance>& measured);

}  // namespace brdf::measured
