// Rows that a format repeats because of its coordinates.
#pragma once

#include <cstddef>
#include <functional>

#include "io/samples/samples.h"

namespace brdf::io {

// Leaves out rows that repeat an earlier row's directions with the same values, because its format has
// several places for a direction: azimuths of 0 and 360 degrees, any azimuth along the normal. Their number
// is added to the warnings. Rows whose values differ are repeat measurements and stay. So do rows that
// somebody wrote twice: `is_written_twice` tells whether two rows of the same directions are one entry of the
// file; without it rows of the same four numbers are.
void leave_out_repetitions(SampleTable& table);
void leave_out_repetitions(SampleTable& table,
                           const std::function<bool(std::size_t, std::size_t)>& is_written_twice);

}  // namespace brdf::io
