// Removes rows that a format repeats because of its coordinates.
#pragma once

#include <cstddef>
#include <functional>

#include "io/samples/samples.h"

namespace brdf::io {

// Removes rows that repeat the directions and the values of an earlier row because the format has several
// places for one direction: azimuths of 0 and 360 degrees, or any azimuth along the normal. The number of
// removed rows is added to the warnings. Rows with different values are repeat measurements and stay. Rows
// that were deliberately written twice stay too: `is_written_twice` returns whether two rows of the same
// directions belong to the same entry of the file. The overload without it compares the four numbers.
void leave_out_repetitions(SampleTable& table);
void leave_out_repetitions(SampleTable& table,
                           const std::function<bool(std::size_t, std::size_t)>& is_written_twice);

}  // namespace brdf::io
