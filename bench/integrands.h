// The competitors of this library's rule for the directional albedo, as an expert would write them. All use
// the forms' batches, all integrate over the mirror-symmetric half of the hemisphere if possible, and each
// has its customary error estimate.
#pragma once

#include <array>
#include <vector>

#include "brdf/material.h"

namespace brdf::bench {

// One lobe of one channel with incidence from (theta, 0), radians; the viewing direction varies.
struct Lobe {
  Term term;
  double theta;
};

// The result of a method for one tolerance.
struct Result {
  double value = 0;
  long evaluations = 0;
  bool claims = false;  // true: the method claims to meet the tolerance; false: it reports a failure
  double seconds = 0;
};

inline constexpr std::array kTolerances{1e-4, 1e-6, 1e-10};
using Results = std::array<Result, kTolerances.size()>;  // one per tolerance

inline constexpr long kMostEvaluations = 1'000'000;

// The rule of this library.
Results pole_adapted(const Lobe& lobe);
// Gauss-Legendre in polar angle and azimuth, with n = 16, 32, 64, ... in each. The error estimate is the
// last change.
Results product_gauss(const Lobe& lobe);
// hcubature (Genz and Malik 1980; Johnson's implementation): bisection with embedded rules.
Results adaptive_cubature(const Lobe& lobe);
// Directions in proportion to the visible normals (Heitz 2018). The error estimate is twice the standard
// error.
Results visible_normals(const Lobe& lobe);

}  // namespace brdf::bench
