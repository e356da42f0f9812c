// Solves a list of candidate models before they are ranked.
#pragma once

#include <vector>

#include "fit/fit.h"
#include "fit/solved.h"

namespace brdf::fit {

struct Candidates {
  FitResult about;          // facts about the samples; the ranking is still empty
  std::vector<Solved> all;  // in the order of the models; fewer if the run is interrupted
};

// Solves every model. Each solution has intervals from the curvature of the cost, and the results of its
// refits. The arguments are as in fit().
Candidates solve_candidates(const Prepared& prepared, const std::vector<std::vector<Reflectance>>& models,
                            const FitOptions& options, const Progress& progress = {},
                            const RefitSolutions* refits = nullptr);

}  // namespace brdf::fit
