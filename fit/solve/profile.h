// Least squares in two levels: a cost as a function of some unknowns, with all others at their optimum.
//
// Many fits that share unknowns form one problem with an arrow matrix. The own unknowns of each fit are
// eliminated separately; the remaining matrix is a sum over the fits (Triggs et al. 2000, section 6.1:
// Schur's complement).
#pragma once

#include <span>
#include <vector>

#include "fit/solve/sample_stream.h"

namespace brdf::fit {

struct Profile {
  Matrix hessian;  // of the kept unknowns, Gauss-Newton
  std::vector<double> gradient;
  // [unknown][kept]: the derivative of each unknown by a kept one. It is 1 for the kept unknown itself and
  // 0 for an unknown at a bound.
  Matrix follows;
  Matrix inverse;  // [unknown][unknown]: inverse of the matrix of the dependent unknowns; 0 elsewhere
};

// Computes the profile at a point that minimises the cost over the other unknowns. `at_bound` is not 0 for
// an unknown that is held. Unknowns do not move along directions without effect.
Profile profile(const NormalEquations& n, std::span<const std::size_t> kept, std::span<const int> at_bound);

// Returns the pseudo-inverse of a symmetric matrix on axes scaled to a diagonal of 1, without the
// directions that have no effect.
Matrix pseudo_inverse(const Matrix& m);

// Returns the covariance for this curvature and this sum of the scores' outer products: H^-1 M H^-1.
Matrix sandwich(const Matrix& hessian, const Matrix& meat);

// Returns A'MA.
Matrix congruent(const Matrix& a, const Matrix& m);

}  // namespace brdf::fit
