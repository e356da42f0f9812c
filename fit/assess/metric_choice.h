// Chooses the residual that suits the data.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fit/model/data.h"

namespace brdf::fit {

// The non-uniformity of a metric's noise: the factor by which the noise of the residuals typically differs
// from its mean (e to the standard deviation of its logarithm over rows and channels). 1 is uniform, as
// least squares assumes.
struct Unevenness {
  Metric metric;
  double factor;
};

struct MetricChoice {
  Metric metric = Metric::log;
  bool asked = true;   // the user asked for this metric; nothing was chosen
  std::string reason;  // reason for the choice, a sentence without its full stop
  // Of the metrics that were compared; empty if the noise is unknown.
  std::vector<Unevenness> unevenness;
};

// Returns the metric that the options request. Metric::automatic chooses from log, cosine_l2 and
// log_relative the metric with the most uniform noise on these data. The noise comes from the scatter of
// the table at different sizes of its values (io::noise_by_level; `noise` is that of all values). The
// choice is log if the noise is unknown or below 0.2 %, and if residuals are divided by their standard
// deviations, which makes all noise uniform. cube_root is robust by itself and has no intervals; it is
// never chosen.
MetricChoice choose_metric(const io::SampleTable& table, const FitData& data, std::optional<double> noise,
                           const FitOptions& options);

}  // namespace brdf::fit
