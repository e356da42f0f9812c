// Which residual the data ask for.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "fit/model/data.h"

namespace brdf::fit {

// How uneven the noise of a metric's residuals is: the factor by which it typically differs from its mean (e
// to the standard deviation of its logarithm over rows and channels); 1: uniform, as least squares want it.
struct Unevenness {
  Metric metric;
  double factor;
};

struct MetricChoice {
  Metric metric = Metric::log;
  bool asked = true;   // for this one: nothing was chosen
  std::string reason;  // of the choice, a sentence without its end
  std::vector<Unevenness>
      unevenness;  // of the metrics that were compared; empty where the noise is not known
};

// The metric the options ask for. Metric::automatic: of log, cosine_l2 and log_relative the one whose noise
// is the most even on these data, from the table's own scatter against the size of its values
// (io::noise_by_level, `noise` being that of all values); log where the scatter is not known or below 0.2 %,
// and where residuals are divided by their standard deviations, which makes all alike. cube_root, robust by
// itself and without intervals, is never chosen.
MetricChoice choose_metric(const io::SampleTable& table, const FitData& data, std::optional<double> noise,
                           const FitOptions& options);

}  // namespace brdf::fit
