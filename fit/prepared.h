// What is known of a fit before any model is.
#pragma once

#include <string>

#include "fit/assess/result.h"
#include "fit/model/data.h"
#include "fit/model/options.h"
#include "io/noise.h"

namespace brdf::fit {

// A table's rows, their residual, their noise.
struct Prepared {
  FitOptions options;  // with the metric that was chosen
  FitData data;
  io::Noise noise;
  MetricChoice metric;
  std::string input_fault;  // a cosine that is left in the values, one clause; empty: none found
};

Prepared prepared(const io::SampleTable& table, const FitOptions& asked);

}  // namespace brdf::fit
