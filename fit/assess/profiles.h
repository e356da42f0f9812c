// Intervals by the profile of the cost.
#pragma once

#include "fit/assess/grounds.h"

namespace brdf::fit {

// Replaces what the curvature said of every parameter. Where one's profile is not quadratic, or a lobe may be absent, all
// of them are looked at again with what the others have found, and from other shapes. Nothing changes where the samples
// have no noise, or the run is interrupted.
void profile_all(std::vector<Reported>& all, const SampleStream& stream, const Grounds& on,
                 const ProfileOptions& options, Uncertainty& out);

}  // namespace brdf::fit
