// Intervals from the profile of the cost.
#pragma once

#include "fit/assess/grounds.h"

namespace brdf::fit {

// Replaces the curvature's intervals of every parameter. If the profile of a parameter is not quadratic, or
// a lobe may be absent, all parameters are searched again with the points that the others found, and from
// other shapes. For samples whose noise is rounding alone, the intervals of the curvature are as good and
// are kept. Nothing changes if the run is interrupted.
void profile_all(std::vector<Reported>& all, const SampleStream& stream, const Grounds& on,
                 const ProfileOptions& options, Uncertainty& out);

}  // namespace brdf::fit
