// Variable projection: for a linear residual the best weights follow from the shape by algebra.
#pragma once

#include "fit/solve.h"
#include "fit/stream.h"

namespace brdf::fit {

// True where the cost is linear least squares in the weights, non-negative, with equal weights for all
// channels.
bool projects(const Stream& stream);

// Fills the linear unknowns of `p` with the best ones for its shapes and returns cost, gradient and
// Gauss-Newton matrix (Kaufman's) by the shape parameters alone. One pass per group of shapes.
NormalEquations project(const Stream& stream, std::vector<double>& p);

// Minimises over the shape parameters alone. Leaves the weights that belong to them in the solution.
Solution solve_projected(const Stream& stream, std::span<const double> start, const SolveOptions& options);

}  // namespace brdf::fit
