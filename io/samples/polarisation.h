// Channels that were measured with polarisers.
#pragma once

#include "io/columns/polarisation_names.h"
#include "io/samples/samples.h"

namespace brdf::io {

// Leaves one channel for all that have one name but for their polarisation. `average`: half the sum of s and
// p, or of ss, sp, ps and pp (the light is a mixture of both polarisations, the viewer takes in both); `s`:
// the channel s, or ss + sp; `ss`: that channel. Standard deviations add up as independent ones. Channels
// without polarisation stay. Throws InputError where no channel has any, where one is missing, or where a
// channel of the new name stands beside.
void choose_polarisation(SampleTable& table, Polarisation asked);

}  // namespace brdf::io
