// Facts about the samples that are known before any model is fitted.
#pragma once

#include "fit/assess/result.h"
#include "fit/model/data.h"
#include "fit/model/options.h"
#include "io/samples/noise.h"
#include "sheet/scatter.h"

namespace brdf::fit {

// The rows of a table, their residual and their noise.
struct Prepared {
  FitOptions options;  // with the metric that was chosen
  FitData data;
  io::Noise noise;
  MetricChoice metric;
  // Agreement of rows that a symmetry makes equal, if their deviation exceeds the noise; otherwise null.
  const sheet::Agreement* agreement = nullptr;

  bool interpolated = false;  // the noise is that of an instrument's software, which interpolated rows

  // Returns the relative noise of one value, the larger of the two estimates. Returns std::nullopt if
  // neither is known.
  std::optional<double> scatter() const {
    if (agreement && agreement->value > noise.value.value_or(0)) return agreement->value;
    return noise.value;
  }
};

// Prepares the table for fits: selects the rows, estimates the noise, and chooses the metric if the options
// leave the choice open. Throws InputError if no rows remain to be fitted.
Prepared prepared(const io::SampleTable& table, const FitOptions& asked);

}  // namespace brdf::fit
