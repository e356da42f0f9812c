// What is known of a fit before any model is.
#pragma once

#include <string>

#include "fit/assess/result.h"
#include "fit/model/data.h"
#include "fit/model/options.h"
#include "io/samples/noise.h"
#include "sheet/scatter.h"

namespace brdf::fit {

// A table's rows, their residual, their noise.
struct Prepared {
  FitOptions options;  // with the metric that was chosen
  FitData data;
  io::Noise noise;
  MetricChoice metric;
  const sheet::Agreement* agreement =
      nullptr;  // of rows that a symmetry makes equal, where it shows more than the noise

  bool interpolated = false;  // the scatter is an instrument's software's

  // Relative, of one value: the larger of the two; none where neither is known.
  std::optional<double> scatter() const {
    if (agreement && agreement->value > noise.value.value_or(0)) return agreement->value;
    return noise.value;
  }
};

Prepared prepared(const io::SampleTable& table, const FitOptions& asked);

}  // namespace brdf::fit
