// Minimisation of a quadratic function within bounds.
#pragma once

#include <span>
#include <vector>

#include "fit/algebra/matrix.h"

namespace brdf::fit {

// Minimises x'Hx/2 + g'x within bounds, exactly, by active sets. H is symmetric and not indefinite. The
// factors are dense for few unknowns, and sparse for many unknowns that mostly do not meet, such as the
// weights of many channels.
std::vector<double> box_quadratic(const Matrix& hessian, std::span<const double> gradient,
                                  std::span<const double> low, std::span<const double> high);

}  // namespace brdf::fit
