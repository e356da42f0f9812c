// Minimisation from a start near the minimum, for many small problems one after another.
#pragma once

#include <span>

#include "fit/solve/solve.h"

namespace brdf::fit {

// Levenberg-Marquardt (Marquardt 1963) whose every step minimises the damped quadratic within the bounds,
// exactly (fit/algebra/box_quadratic.h): what a bound holds and what it releases is decided in the step, and
// no problem is set up. Ends where the quadratic promises less than `tolerance` of the cost, or the next one
// would by how these promises fall. The solution is that of solve(): the same cost, the same bounds.
Solution solve_nearby(const Objective& objective, std::span<const double> start, std::span<const double> low,
                      std::span<const double> high, const SolveOptions& options);

}  // namespace brdf::fit
