// Deterministic search for the largest value of a function on the unit cube.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "validate/search/budget.h"

namespace brdf::validate {

struct SearchOptions {
  std::size_t cover = 256;   // points of the low-discrepancy cover
  std::size_t starts = 6;    // number of best points that climbs start from
  int steps = 60;            // per climb; each costs about two evaluations per dimension
  double coarse = 1e-3;      // step at which these climbs end
  std::size_t polish = 2;    // number of best summits that are refined further
  double finest = 1e-7;      // step at which the refinement ends
  std::uint64_t seed = 1;    // shifts the cover
  bool any_thread = false;   // the function may be called on several threads at a time
  Budget* budget = nullptr;  // points beyond it are not evaluated and count as lowest
};

struct Best {
  std::vector<double> point;
  double value;
  long calls;
};

using Objective = std::function<double(std::span<const double>)>;

// Returns the first 2^most corners of the unit cube; coordinate d of a corner is bit d of its number.
std::vector<std::vector<double>> cube_corners(std::size_t dimensions, std::size_t most);

// Returns the k-th point of the additive recurrence with the generalised golden ratio (Roberts 2018),
// shifted by `seed`.
std::vector<double> cover_point(std::size_t k, std::size_t dimensions, std::uint64_t seed);

// Evaluates the cover and `extra`, then climbs from the best points by pattern search (Hooke and Jeeves
// 1961). Pattern search needs no derivatives, tolerates kinks, and reaches the faces of the cube exactly.
// NaN counts as lowest. If `exact` is given, the best summits are climbed to the finest step with `exact`;
// use it when a rough value of the function is cheaper.
Best maximise(const Objective& f, std::size_t dimensions, const SearchOptions& options,
              const std::vector<std::vector<double>>& extra = {}, const Objective& exact = {});

// Finds the largest value of a function that is rough at every scale, such as a rounding error. A quarter
// of the evaluations cover the cube; the others move the best points at random, by steps of every size.
Best maximise_rough(const Objective& f, std::size_t dimensions, std::size_t evaluations, std::uint64_t seed);

}  // namespace brdf::validate
