// Starting points of the search for minima.
#pragma once

#include <random>
#include <vector>

#include "fit/solve/sample_stream.h"

namespace brdf::fit {

// Returns value k of n over the range of a slot, on the solver's scale.
double grid_value(const Slot& slot, std::size_t k, std::size_t n);

// Returns a grid over the distinct shape parameters. The sets of shapes of all channels share a grid point.
std::vector<std::vector<double>> grid_starts(const Model& model);

// Returns a random point within the ranges of the starting points.
std::vector<double> random_start(const Model& model, std::mt19937_64& random);

// Fills in the best weights for the shapes of p under the residual linearised at the measurement.
void start_weights(const SampleStream& stream, std::vector<double>& p);

}  // namespace brdf::fit
