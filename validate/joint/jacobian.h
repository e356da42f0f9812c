// The true density of a sampler at a direction, without noise: from the area of directions per area of random
// numbers.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "validate/joint/trio.h"

namespace brdf::validate {

// Random numbers that lead to a direction, and the density that they contribute there, 1/sr.
struct DensityPart {
  std::vector<double> u;
  double density;
};

// A direction with the density that the code claims and the density that the sampler has, per solid angle.
struct DensityRow {
  Vec3<double> wi;
  double claimed, truth;
  std::vector<double> u;  // the random numbers that led to the direction
  // The truth as a sum over all random numbers that lead to the direction, as far as they were found.
  std::vector<DensityPart> parts = {};
};

// The true density is the sum over all random numbers u that lead to the direction of the probability of the
// choices made there, over |dL/du|. The u are found by Newton's method from many starts. Derivatives are
// central differences of fourth order in double; their relative accuracy is about 1e-7, and directions at
// which two orders differ by more are left out.
struct JacobianRows {
  std::vector<DensityRow> rows;  // of the directions that could be judged
  int probes = 0;                // directions that were examined
  std::string why = {};          // the reason if few could be judged
};
JacobianRows jacobian_rows(const Trio& trio, int probes, std::uint64_t seed);

// Relative difference from which a row counts as wrong.
inline constexpr double kJacobianBound = 1e-4;

// Returns whether two densities differ by at most `bound` of the larger one.
inline bool agree(double a, double b, double bound) {
  return std::abs(a - b) <= bound * std::max(std::abs(a), std::abs(b));
}

}  // namespace brdf::validate
