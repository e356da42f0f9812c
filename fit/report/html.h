// The report of one fit, as a self-contained HTML file.
#pragma once

#include <string>

#include "fit/assess/result.h"
#include "fit/model/options.h"
#include "io/samples/samples.h"

namespace brdf::fit {

// Verdict with its warnings, a sphere (unless it is not wanted), slices with bands, where the fit deviates,
// parameters, ranking, samples; correlations and minima folded (fit/report/page.h).
std::string html_report(const FitResult& result, const io::SampleTable& table, const FitOptions& options,
                        bool sphere = true);

}  // namespace brdf::fit
