// Every model's solution and what it is worth.
#pragma once

#include <optional>
#include <vector>

#include "fit/assess/result.h"
#include "fit/model/data.h"
#include "fit/model/model.h"
#include "fit/model/options.h"
#include "fit/solve/residual.h"

namespace brdf::fit {

// A form's fit and what refits need of it.
struct Solved {
  FormFit fit;
  Model model;
  Residual residual;
  std::vector<double> p;
};

// In the models' order; the first and those that were begun where the run is interrupted. `noise`: relative, where it is
// known.
std::vector<Solved> fit_models(const FitData& data, const std::vector<std::vector<Reflectance>>& models,
                               const FitOptions& options, std::optional<double> noise,
                               const Progress& progress);

}  // namespace brdf::fit
