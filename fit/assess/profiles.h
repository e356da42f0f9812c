// Intervals by the profile of the cost.
#pragma once

#include "fit/assess/grounds.h"

namespace brdf::fit {

// Replaces what the curvature said of every parameter. Where one's profile is not quadratic, or a lobe may be
// absent, all of them are looked at again with what the others have found, and from other shapes. Of samples
// that scatter by rounding alone the curvature's intervals are as good. Nothing changes where the run is
// interrupted.
void profile_all(std::vector<Reported>& all, const SampleStream& stream, const Grounds& on,
                 const ProfileOptions& options, Uncertainty& out);

}  // namespace brdf::fit
