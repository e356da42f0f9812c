// Writes the report of one fit as a self-contained HTML file.
#pragma once

#include <string>

#include "fit/assess/result.h"
#include "fit/model/options.h"
#include "io/samples/samples.h"

namespace brdf::fit {

// Returns the page: the verdict with its warnings, a sphere (if `sphere` is true), slices with bands, a map
// of the deviations, parameters, ranking, samples; correlations and minima are folded (fit/report/page.h).
std::string html_report(const FitResult& result, const io::SampleTable& table, const FitOptions& options,
                        bool sphere = true);

}  // namespace brdf::fit
