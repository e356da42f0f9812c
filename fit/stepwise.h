// A model of as many terms as the samples ask for.
#pragma once

#include "fit/assess/result.h"
#include "fit/prepared.h"

namespace brdf::fit {

// Starts with the simplest diffuse form and adds, step by step, one lobe, a better diffuse term, a second
// lobe, as long as the objective on left-out rows falls significantly (FitResult::steps says by how much).
// Each step tries every candidate of its kind and takes the one with the fewest parameters that is as good as
// the best: within 10 % and not worse by paired_ratio_test. That test's probability of the fall is multiplied
// by the number tried (Bonferroni); kept is what stays below 5 % and gains 1 % of the left-out value at
// least. Candidates are told by what the catalogue states of them: the canonical forms and those whose
// facets' slopes have a parameter besides their widths; for a second lobe those of them without known
// violations. In a sum f0 is one for all channels unless options.tie says otherwise. A second lobe is sought
// from the shapes of the model without it, too. The ranking holds every model tried, the chosen one first.
// `progress` hears what is tried next. Throws InputError where no rows can be left out, so that no step can
// be judged.
FitResult fit_stepwise(const Prepared& prepared, const Progress& progress = {});

}  // namespace brdf::fit
