// Every model's solution and what it is worth.
#pragma once

#include <optional>
#include <vector>

#include "fit/assess/assess.h"
#include "fit/assess/result.h"
#include "fit/model/data.h"
#include "fit/model/model.h"
#include "fit/model/options.h"
#include "fit/solve/residual.h"

namespace brdf::fit {

// A form's fit and what refits and profiles need of it.
struct Solved {
  FormFit fit;
  Model model;
  Residual residual;
  std::vector<double> p;
  Minimum minimum;
  std::vector<std::vector<double>> other_minima;  // the solver's parameters
  std::vector<std::string> before, after;         // findings beside those of the uncertainty
  Misfit misfit;
};

// In the models' order; the first and those that were begun where the run is interrupted. `noise`: relative,
// where it is known.
std::vector<Solved> fit_models(const FitData& data, const std::vector<std::vector<Reflectance>>& models,
                               const FitOptions& options, std::optional<double> noise,
                               const Progress& progress);

// What --physical costs this form: it is tried.
std::string physical_in_words(const FitData& data, const FitOptions& options, const Solved& solved);

// Replaces the intervals of the curvature by those of the cost's profile, and what follows from them: which
// parameters the samples tell, and the verdict. False, and nothing changes, where it has them already, where
// there are too many rows (the intervals stay approximate), or where the run is interrupted.
bool profile_intervals(const FitData& data, const FitOptions& options, const Progress& progress,
                       Solved& solved);

}  // namespace brdf::fit
