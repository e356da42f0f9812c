// The solution of every model and its assessment.
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

// The fit of a form, with the data that refits and profiles need.
struct Solved {
  FormFit fit;
  Model model;
  Residual residual;
  std::vector<double> p;
  Minimum minimum;
  std::vector<std::vector<double>> other_minima;  // in the solver's parameters
  std::vector<std::string> before, after;         // findings in addition to the findings of the uncertainty
  Misfit misfit;
  std::string below_zero;  // the reason why f may be below 0 for these weights; empty if f is not
};

// Fits the models and returns the solutions in the order of the models. If the run is interrupted, only the
// first model and the models already begun are returned. `noise` is relative; std::nullopt if unknown.
std::vector<Solved> fit_models(const FitData& data, const std::vector<std::vector<Reflectance>>& models,
                               const FitOptions& options, std::optional<double> noise,
                               const Progress& progress);

// Returns a sentence on the cost of --physical for this form, which is fitted with the option to find out.
std::string physical_in_words(const FitData& data, const FitOptions& options, const Solved& solved);

// Replaces the intervals of the curvature by intervals of the cost's profile, and updates the results that
// depend on them: which parameters the samples identify, and the verdict. Returns false and changes nothing
// if the solution already has such intervals, if there are too many rows (the intervals stay approximate),
// or if the run is interrupted.
bool profile_intervals(const FitData& data, const FitOptions& options, const Progress& progress,
                       Solved& solved);

}  // namespace brdf::fit
