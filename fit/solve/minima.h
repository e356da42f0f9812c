// The starting points, and the distinct minima that they reach.
#pragma once

#include <vector>

#include "fit/solve/sample_stream.h"
#include "fit/solve/solve.h"

namespace brdf::fit {

inline constexpr double kSameCost = 1e-6;  // relative difference of equal costs

struct Minimum {
  std::vector<double> p;
  double cost = 0;
  int basin = 0;  // number of starts that ended here
  std::vector<int> at_bound;
  Termination termination = Termination::failed;
  std::string message;
};

struct SearchResult {
  std::vector<Minimum> minima;  // distinct, best first, solved on all rows
  int starts = 0, passes = 0, iterations = 0;
  bool interrupted = false;
  double loss_scale = 0;
};

// Finds the minima of the cost. The starting points are a deterministic grid of shapes (12 points in one
// dimension, 6 x 6 in two), --start, and random points. Each has the best weights of the linearised
// residual. If there are many rows, a thinned set is solved first.
SearchResult find_minima(const FitData& data, const Model& model, const Residual& residual,
                         const FitOptions& options);

// Returns the residual that the options request. Throws InputError if the loss cannot be combined with the
// metric.
Residual chosen_residual(const FitData& data, const FitOptions& options);

// Returns the scale of a robust loss from the normalised median deviation of the residuals.
double robust_scale(const SampleStream& stream, const LossFunction& loss, std::span<const double> p);

// Solves from one starting point on all rows. Used for refits.
Solution refine(const SampleStream& stream, std::span<const double> start, const SolveOptions& options);

}  // namespace brdf::fit
