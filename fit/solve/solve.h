// Minimisation of a cost known by its normal equations, within bounds.
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
  int max_iterations = 400;         // cube_root converges linearly
  double tolerance = 1e-12;         // relative, on cost and step
  bool starts_at_solution = false;  // of nearly the same samples: what is held there is held from the start
  const std::atomic<bool>* interrupted = nullptr;
};

struct Solution {
  std::vector<double> p;
  double cost = 0;
  Termination termination = Termination::failed;
  std::string message;        // the solver's own words
  std::vector<int> at_bound;  // [parameter]: -1 held at its lower bound, 1 at its upper, 0 free
  int passes = 0, iterations = 0;
};

// Which parameters are held at a bound (-1 below, 1 above), and sets them to it: those at one where the cost
// pushes outward, or does not care.
std::vector<int> hold_at_bounds(const NormalEquations& n, std::vector<double>& p, std::span<const double> low,
                                std::span<const double> high);

// Levenberg-Marquardt (Ceres) on the p + 1 residuals that have the same cost,
// gradient and Gauss-Newton matrix as the samples (Cholesky). Ceres stops early
// where a bound is active, and calls it convergence: parameters at a bound that the
// cost pushes against are held there and the rest solved again, until none moves.
Solution solve(const Objective& objective, std::span<const double> start, std::span<const double> low,
               std::span<const double> high, const SolveOptions& options);

}  // namespace brdf::fit
