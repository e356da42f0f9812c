// Combines channels that were measured with polarisers.
#pragma once

#include "io/columns/polarisation_names.h"
#include "io/samples/samples.h"

namespace brdf::io {

// Replaces all channels whose names differ only in polarisation by one channel:
// - `average`: half the sum of s and p, or of ss, sp, ps and pp. The light is a mixture of both
//   polarisations, and the viewer receives both.
// - `s` or `p`: the channel s or p, or the sum ss + sp or ps + pp.
// - `ss`, `sp`, `ps` or `pp`: that channel.
// Standard deviations are combined as independent ones, provided that all channels of the sum have them.
// Channels without a polarisation stay. Throws InputError if no channel has a polarisation, if a required
// one is missing or given twice, or if a channel of the new name already exists.
void choose_polarisation(SampleTable& table, Polarisation asked);

}  // namespace brdf::io
