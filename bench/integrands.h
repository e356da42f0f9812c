// The competitors of our rule for the directional albedo, as an expert would write them: all through the
// forms' batches, all on the mirror-symmetric half of the hemisphere where they can, each with the error
// estimate that users of it have.
#pragma once

#include <array>
#include <vector>

#include "brdf/material.h"

namespace brdf::bench {

// One lobe of one channel under light from (theta, 0), radians; the viewer moves.
struct Lobe {
  Term term;
  double theta;
};

struct Result {
  double value = 0;
  long evaluations = 0;
  bool claims = false;  // that the tolerance is met; otherwise it said that it is not
  double seconds = 0;
};

inline constexpr std::array kTolerances{1e-4, 1e-6, 1e-10};
using Results = std::array<Result, kTolerances.size()>;  // one per tolerance

inline constexpr long kMostEvaluations = 1'000'000;

// The project's own rule.
Results pole_adapted(const Lobe& lobe);
// Gauss-Legendre in polar angle and azimuth, n = 16, 32, 64, ... in each; the error is the last change.
Results product_gauss(const Lobe& lobe);
// hcubature (Genz and Malik 1980; Johnson's implementation): bisection with embedded rules.
Results adaptive_cubature(const Lobe& lobe);
// Directions in proportion to the visible normals (Heitz 2018); the error is twice the standard error.
Results visible_normals(const Lobe& lobe);

}  // namespace brdf::bench
