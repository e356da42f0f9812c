// Writes the report of one fit as a self-contained HTML file.
#pragma once

#include <optional>
#include <string>

#include "fit/assess/result.h"
#include "fit/model/options.h"
#include "io/samples/samples.h"

namespace brdf::fit {

// Returns the page: the facts about the measurements, the verdict with its warnings, a sphere (if
// `sphere` is true), slices with bands, a map of the deviations, parameters, ranking, samples;
// correlations and minima are folded (fit/report/page.h).
// `tolerance`: a fraction that the page judges the median error (fitted) by; readers can change it.
// Example:
//     // #include "brdf/fit/fit.h"
//     // #include "brdf/io/formats/read.h"
//     const brdf::io::SampleTable table = brdf::io::read_samples("matt.csv");
//     const auto result = brdf::fit::fit(table, {{*brdf::find_form("lambert")}}, {});
//     std::ofstream("matt.html") << html_report(result, table, {}, false);
std::string html_report(const FitResult& result, const io::SampleTable& table, const FitOptions& options,
                        bool sphere = true, std::optional<double> tolerance = std::nullopt);

}  // namespace brdf::fit
