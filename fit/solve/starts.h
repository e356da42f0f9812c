// Where the search for minima starts.
#pragma once

#include <random>
#include <vector>

#include "fit/solve/sample_stream.h"

namespace brdf::fit {

// Value k of n over a slot's range, on the solver's scale.
double grid_value(const Slot& slot, std::size_t k, std::size_t n);

// A grid over the distinct shape parameters; sets of shapes per channel share a point.
std::vector<std::vector<double>> grid_starts(const Model& model);

std::vector<double> random_start(const Model& model, std::mt19937_64& random);

// Fills in the best weights for the shapes of p under the residual linearised at the measurement.
void start_weights(const SampleStream& stream, std::vector<double>& p);

}  // namespace brdf::fit
