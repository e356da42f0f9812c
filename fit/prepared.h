// Facts about the samples that are known before any model is fitted.
#pragma once

#include "fit/assess/result.h"
#include "fit/model/data.h"
#include "fit/model/options.h"
#include "sheet/scatter.h"

namespace brdf::fit {

// The rows of a table, their residual and their noise.
struct Prepared {
  FitOptions options;  // with the metric that was chosen
  FitData data;
  sheet::Scatter noise;  // with the neighbours' noise of the rows to fit
  MetricChoice metric;
  bool interpolated = false;  // the noise is that of an instrument's software, which interpolated rows

  // Return the relative noise of one value, and the part of it that is known to be noise; std::nullopt if it
  // is not known. See sheet::Scatter.
  std::optional<double> scatter() const { return noise.value(!options.anisotropic); }
  std::optional<double> least_scatter() const { return noise.least(!options.anisotropic); }
};

// Prepares the table for fits: selects the rows, estimates the noise, and chooses the metric if the options
// leave the choice open. Throws InputError if no rows remain to be fitted.
Prepared prepared(const io::SampleTable& table, const FitOptions& asked);

}  // namespace brdf::fit
