// Models solved side by side, before they are ranked.
#pragma once

#include <vector>

#include "fit/fit.h"
#include "fit/solved.h"

namespace brdf::fit {

struct Candidates {
  FitResult about;          // of the samples: no ranking yet
  std::vector<Solved> all;  // in the models' order; fewer where the run is interrupted
};

// Every model's solution, its intervals by the curvature, and what its refits say. As fit() otherwise.
Candidates solve_candidates(const Prepared& prepared, const std::vector<std::vector<Reflectance>>& models,
                            const FitOptions& options, const Progress& progress = {},
                            const RefitSolutions* refits = nullptr);

}  // namespace brdf::fit
