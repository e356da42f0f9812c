// Minimisation from a start near the minimum, for a sequence of many small problems.
#pragma once

#include <span>

#include "fit/solve/solve.h"

namespace brdf::fit {

// Minimises by Levenberg-Marquardt (Marquardt 1963), with the damping of Nielsen (1999). Every step
// minimises the damped quadratic within the bounds, exactly (fit/algebra/box_quadratic.h). The step itself
// decides which parameters a bound holds or releases, and no problem object is set up. Stops if the
// quadratic predicts a reduction of less than `tolerance` of the cost, or if the trend of the predictions
// implies this for the next step. The solution equals that of solve(): the same cost, the same bounds.
Solution solve_nearby(const Objective& objective, std::span<const double> start, std::span<const double> low,
                      std::span<const double> high, const SolveOptions& options);

}  // namespace brdf::fit
