// The report of one fit, as a self-contained HTML file.
#pragma once

#include <string>

#include "fit/assess/result.h"
#include "fit/model/options.h"
#include "io/samples.h"

namespace brdf::fit {

// Measured against fitted in-plane slices, residual map over (theta_h, theta_d), parameters with intervals,
// correlations, minima, metrics, ranking, and the verdict in words.
std::string html_report(const FitResult& result, const io::SampleTable& table, const FitOptions& options);

}  // namespace brdf::fit
