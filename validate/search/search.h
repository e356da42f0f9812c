// Search for the largest value of a function on the unit cube. Deterministic.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "validate/search/budget.h"

namespace brdf::validate {

struct SearchOptions {
  std::size_t cover = 256;   // points of the low-discrepancy cover
  std::size_t starts = 6;    // of these, the best are climbed from
  int steps = 60;            // of a climb; each costs about two evaluations per dimension
  double coarse = 1e-3;      // step at which these climbs end
  std::size_t polish = 2;    // the best of their summits are climbed on from
  double finest = 1e-7;      // step at which that ends
  std::uint64_t seed = 1;    // shifts the cover
  Budget* budget = nullptr;  // points beyond it count as lowest, unseen
};

struct Best {
  std::vector<double> point;
  double value;
  long calls;
};

using Objective = std::function<double(std::span<const double>)>;

// Those of the unit cube, the first 2^most of them: coordinate d is bit d of the number.
std::vector<std::vector<double>> cube_corners(std::size_t dimensions, std::size_t most);

// The k-th point of the additive recurrence with the generalised golden ratio (Roberts 2018), shifted.
std::vector<double> cover_point(std::size_t k, std::size_t dimensions, std::uint64_t seed);

// Evaluates the cover and `extra`, then climbs from the best points by pattern search
// (Hooke and Jeeves 1961), which needs no derivatives, stands kinks, and reaches the
// cube's faces exactly. NaN counts as lowest. The best summits are climbed to the
// finest step with `exact`, where a function is cheaper to have roughly.
Best maximise(const Objective& f, std::size_t dimensions, const SearchOptions& options,
              const std::vector<std::vector<double>>& extra = {}, const Objective& exact = {});

// The same for a function that is rough at every scale, as rounding errors are: a quarter of the evaluations
// cover the cube, the others move its best points at random, by steps of every size.
Best maximise_rough(const Objective& f, std::size_t dimensions, std::size_t evaluations, std::uint64_t seed);

}  // namespace brdf::validate
