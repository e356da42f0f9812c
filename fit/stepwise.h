// Builds a model with as many terms as the samples justify.
#pragma once

#include "fit/assess/result.h"
#include "fit/prepared.h"

namespace brdf::fit {

// Starts with the simplest diffuse form and adds, step by step, one lobe, a better diffuse term and a
// second lobe. A step is kept only if the held-out objective falls significantly (FitResult::steps gives
// the amount).
//
// Three more steps are for special surfaces. A retroreflective lobe is tried if the samples about the
// direction of the light are a quarter above the model. A matt basis is tried in place of the whole model,
// then as the body under its lobes, or a lobe on the basis. With four lights a basis has at most five
// weights, with five eight, with six fourteen. Unless such a step is kept, it leaves no trace in the result.
//
// Each step tries every candidate of its kind. The step takes the candidate with the fewest parameters that
// is as good as the best one: within 10 % and not worse by paired_ratio_test. The p-value of this test for
// the fall is multiplied by the number of candidates (Bonferroni). Steps with p below 5 % that lower the
// held-out value by at least 1 % are kept.
//
// Candidates are selected by the facts in the catalogue: the canonical forms, and the forms whose slope
// distribution has a parameter in addition to its widths. A second lobe must be one of these forms without
// known violations. In a sum, f0 has one value for all channels unless options.tie specifies otherwise. One
// of the starts of the search for a second lobe has the shapes of the model without that lobe.
//
// The ranking holds every model tried, the chosen one first. `progress` is called with a description of
// each step before it is tried. Throws InputError if no rows can be held out, because then no step can be
// judged.
// Example:
//     // #include "brdf/io/formats/read.h"
//     const auto prepared = brdf::fit::prepared(brdf::io::read_samples("matt.csv"), {});
//     const auto result = fit_stepwise(prepared, [](const std::string& step) { std::puts(step.c_str()); });
//     std::printf("chosen: %s\n", result.ranking.front().form.c_str());
FitResult fit_stepwise(const Prepared& prepared, const Progress& progress = {});

}  // namespace brdf::fit
