// Minimisation within bounds of a cost that is given by its normal equations.
#pragma once

#include <array>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "brdf/names.h"
#include "fit/solve/sample_stream.h"

namespace brdf::fit {

// A function that returns the normal equations at given parameters.
using Objective = std::function<NormalEquations(std::span<const double>)>;

enum class Termination { converged, iteration_limit, failed, interrupted };

}  // namespace brdf::fit

namespace brdf {

template <>
inline constexpr std::array<std::string_view, 4> kNames<fit::Termination>{"converged", "iteration_limit",
                                                                          "failed", "interrupted"};

}  // namespace brdf

namespace brdf::fit {

struct SolveOptions {
  int max_iterations = 400;  // cube_root converges linearly
  double tolerance = 1e-12;  // relative, on cost and step
  // The start is a solution for nearly the same samples; parameters at a bound there are held from the
  // start.
  bool starts_at_solution = false;
  const std::atomic<bool>* interrupted = nullptr;
};

struct Solution {
  std::vector<double> p;
  double cost =
      0;  // at the last evaluated point, from which a last step of less than its rounding leads to p
  Termination termination = Termination::failed;
  std::string message;        // the message of the solver
  std::vector<int> at_bound;  // [parameter]: -1 held at its lower bound, 1 at its upper, 0 free
  int passes = 0, iterations = 0;
};

// Returns the parameters that are held at a bound (-1 lower, 1 upper) and sets them to it. A parameter at a
// bound is held if the cost pushes it outward or does not depend on it.
std::vector<int> hold_at_bounds(const NormalEquations& n, std::vector<double>& p, std::span<const double> low,
                                std::span<const double> high);

// Minimises by Levenberg-Marquardt (Ceres). The solver sees p + 1 residuals that have the same cost,
// gradient and Gauss-Newton matrix as the samples (Cholesky). Ceres stops early if a bound is active, and
// reports convergence. Therefore parameters at a bound that the cost pushes against are held there, and the
// others are solved again, until the set does not change. A converged solution takes one undamped step more,
// without a pass, unless it would leave the bounds.
Solution solve(const Objective& objective, std::span<const double> start, std::span<const double> low,
               std::span<const double> high, const SolveOptions& options);

}  // namespace brdf::fit
