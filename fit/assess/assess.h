// What a solution is worth: errors, noise, uncertainty, identifiability.
#pragma once

#include <optional>

#include "fit/assess/result.h"
#include "fit/model/data.h"
#include "fit/solve/minima.h"
#include "fit/solve/sample_stream.h"

namespace brdf::fit {

// The four metrics of the model's values [channel][row].
Metrics measure(const FitData& data, const std::vector<std::vector<double>>& model);

// How far values scatter about their neighbours of the same incidence, relative; none where rows have too few
// neighbours. An upper bound of the noise: what structure neighbours do not share counts as well.
std::optional<double> noise_floor(const FitData& data);

struct Uncertainty {
  std::vector<Estimate> estimates;
  Correlations correlations;
  double condition = 1;
  bool singular = false;              // some parameter has no effect, or only together with others
  bool sum_at_bound = false;          // what --physical bounds together
  std::vector<std::string> findings;  // about bounds and identifiability
};

// Heteroscedasticity-consistent covariance at a solution, rows independent, channels of a row not.
Uncertainty uncertainty(const SampleStream& stream, const Minimum& solution);

// The residual far above the noise: enough of the reflected light is in the wrong place.
struct Misfit {
  bool misfit = false;
  std::string finding;
};
Misfit judge_misfit(const FitData& data, const std::vector<std::vector<double>>& model,
                    std::optional<double> noise);

}  // namespace brdf::fit
