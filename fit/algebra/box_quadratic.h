// Minimisation of a quadratic function within bounds.
#pragma once

#include <span>
#include <vector>

#include "fit/algebra/matrix.h"

namespace brdf::fit {

// Minimises x'Hx/2 + g'x within bounds, exactly, by active sets. Meant for the few unknowns of one
// channel's weights.
std::vector<double> box_quadratic(const Matrix& hessian, std::span<const double> gradient,
                                  std::span<const double> low, std::span<const double> high);

}  // namespace brdf::fit
