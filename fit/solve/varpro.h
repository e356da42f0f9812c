// Variable projection: for a linear residual the best weights follow from the shape by algebra.
#pragma once

#include "fit/solve/sample_stream.h"
#include "fit/solve/solve.h"

namespace brdf::fit {

// True where the cost is linear least squares in the weights,
// non-negative, with equal weights for all channels.
bool projects(const SampleStream& stream);

// Fills the linear unknowns of `p` with the best ones for its shapes and returns cost, gradient and
// Gauss-Newton matrix (Kaufman's) by the shape parameters alone. One pass per group of shapes.
// `square` receives half the sum of the squared measurements.
NormalEquations project(const SampleStream& stream, std::vector<double>& p, double& square);

// Minimises over the shape parameters alone. Leaves the weights that belong
// to them in the solution. The projected cost is a difference of sums:
// `exact` is false where the fit is so good that it has lost its digits.
Solution solve_projected(const SampleStream& stream, std::span<const double> start,
                         const SolveOptions& options, bool& exact);

}  // namespace brdf::fit
