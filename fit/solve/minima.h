// Where to start, and the distinct minima that the starts reach.
#pragma once

#include <vector>

#include "fit/solve/sample_stream.h"
#include "fit/solve/solve.h"

namespace brdf::fit {

inline constexpr double kSameCost = 1e-6;  // relative difference of equal costs

struct Minimum {
  std::vector<double> p;
  double cost = 0;
  int basin = 0;  // starts that ended here
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

// Deterministic grid of shapes (12 points in one dimension, 6 x 6 in two), --start and random starts; each
// with the best weights of the linearised residual; solved on a thinned set first where there are many rows.
SearchResult find_minima(const FitData& data, const Model& model, const Residual& residual,
                         const FitOptions& options);

// The residual that the options ask for. Throws InputError where a loss does not go with the metric.
Residual chosen_residual(const FitData& data, const FitOptions& options);

// A robust loss's scale by the residuals' normalised median deviation.
double robust_scale(const SampleStream& stream, const LossFunction& loss, std::span<const double> p);

// Solves from one point on all rows: for refits.
Solution refine(const SampleStream& stream, std::span<const double> start, const SolveOptions& options);

}  // namespace brdf::fit
