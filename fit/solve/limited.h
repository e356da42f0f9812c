// Minimisation of a cost within bounds and limits of the weights that hold exactly.
#pragma once

#include <span>

#include "fit/solve/solve.h"

namespace brdf::fit {

// Minimises the cost of the samples subject to the bounds and to the limits of the model (Model::cuts()), by
// Levenberg-Marquardt. Every step minimises the damped quadratic subject to all of them at once, by its dual:
// a quadratic in multipliers that are not negative. The start may break limits; the first step then restores
// them.
Solution solve_limited(const SampleStream& stream, std::span<const double> start,
                       const SolveOptions& options);

}  // namespace brdf::fit
