// The true density of a sampler at a direction, without noise: from the area of directions per area of random
// numbers.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "validate/joint/trio.h"

namespace brdf::validate {

// A direction with the density that the code claims and the density that the sampler has, per solid angle.
struct DensityRow {
  Vec3<double> wi;
  double claimed, truth;
  std::vector<double> u;  // the random numbers that led to the direction
  std::size_t roots = 1;  // how many random numbers that lead to the direction were found
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

// Returns the cause of a wrong density, as a clause that follows "the density": a density of another measure,
// a constant factor, exchanged axes or directions; empty if no known cause explains the rows.
std::string cause_of(const Trio& trio, std::span<const DensityRow> rows);

}  // namespace brdf::validate
