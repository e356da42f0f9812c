// Least squares in two levels: a cost as a function of some unknowns while all others follow them.
//
// Many fits that share unknowns are one problem whose matrix is an arrow: each fit's own unknowns are
// eliminated by themselves, and what is left are sums over the fits (Triggs et al. 2000, section 6.1: Schur's
// complement).
#pragma once

#include <span>
#include <vector>

#include "fit/solve/sample_stream.h"

namespace brdf::fit {

struct Profile {
  Matrix hessian;  // of the kept unknowns, Gauss and Newton's
  std::vector<double> gradient;
  // [unknown][kept]: how each unknown moves with a kept one; that one itself by 1, one at a bound by 0.
  Matrix follows;
  Matrix inverse;  // [unknown][unknown]: of the matrix of those that follow; 0 elsewhere
};

// At a point where the cost has its minimum by the others. `at_bound`: not 0 for an unknown that is held.
// Along directions without effect nothing follows.
Profile profile(const NormalEquations& n, std::span<const std::size_t> kept, std::span<const int> at_bound);

// Of a symmetric matrix on axes scaled to a diagonal of 1, without the directions that have no effect.
Matrix pseudo_inverse(const Matrix& m);

// The covariance of what has this curvature and this sum of scores' outer products: H^-1 M H^-1.
Matrix sandwich(const Matrix& hessian, const Matrix& meat);

// A'MA.
Matrix congruent(const Matrix& a, const Matrix& m);

}  // namespace brdf::fit
