// Variable projection: for a linear residual the best weights follow from the shape by algebra.
#pragma once

#include "fit/solve/sample_stream.h"
#include "fit/solve/solve.h"

namespace brdf::fit {

// Returns whether the cost is linear least squares in weights that have no limits but their bounds, with
// equal row weights for all channels.
bool projects(const SampleStream& stream);

// Fills the linear unknowns of `p` with the best ones for its shapes. Returns cost, gradient and
// Gauss-Newton matrix (Kaufman's) by the shape parameters alone. Takes one pass per group of shapes.
// `square` receives half the sum of the squared measurements.
NormalEquations project(const SampleStream& stream, std::vector<double>& p, double& square);

// Minimises over the shape parameters alone. The solution contains the corresponding weights. The projected
// cost is a difference of sums: `exact` is false if the fit is so good that the difference has lost its
// digits.
Solution solve_projected(const SampleStream& stream, std::span<const double> start,
                         const SolveOptions& options, bool& exact);

}  // namespace brdf::fit
