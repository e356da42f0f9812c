// Tests the convention of azimuths of another program's table on the values.
#pragma once

#include "io/samples/samples.h"

namespace brdf::io {

// Compares the largest values near the mirror direction and near the incident direction, for angles of
// incidence from 20 degrees on. Adds an assumption if the values near the incident direction are larger by
// a quarter for most of these angles: the sample is retroreflective, or the azimuths of the file follow
// another convention. A table without rows on both sides is not judged.
void check_highlight(SampleTable& table);

}  // namespace brdf::io
