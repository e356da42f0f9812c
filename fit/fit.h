// From samples to parameters with honest uncertainty.
#pragma once

#include <vector>

#include "brdf/reflectance.h"
#include "fit/assess/result.h"
#include "fit/model/data.h"
#include "fit/model/options.h"

namespace brdf::fit {

// Fits each model (a form, or several that are summed). Without any it chooses one step by step (fit/stepwise.h).
// `progress` hears each before it is fitted. Throws InputError on options that do not fit.
FitResult fit(const io::SampleTable& table, const std::vector<std::vector<Reflectance>>& models,
              const FitOptions& options, const Progress& progress = {});

// The canonical forms, or all that can be fitted.
std::vector<std::vector<Reflectance>> canonical_models();
std::vector<std::vector<Reflectance>> every_model();

}  // namespace brdf::fit
