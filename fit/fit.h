// From samples to parameters with honest uncertainty.
#pragma once

#include <vector>

#include "brdf/reflectance.h"
#include "fit/assess/result.h"
#include "fit/model/options.h"
#include "fit/prepared.h"
#include "fit/samples.h"

namespace brdf::fit {

// The solver's parameters of each refit (fit/assess/refits.h); empty of a model that has no solution.
using RefitSolutions = std::vector<std::vector<double>>;

// Fits each model (a form, or several that are summed). Without any it chooses one step by step
// (fit/stepwise.h). `progress` hears each before it is fitted. `refits`: those of all models, which
// solve_refits() gave, and which are then not solved again. Throws InputError on options that do not fit. The
// result holds the samples' sheet, and judges lack of fit by the scatter that the sheet found.
FitResult fit(const Samples& samples, const std::vector<std::vector<Reflectance>>& models,
              const FitOptions& options, const Progress& progress = {},
              const RefitSolutions* refits = nullptr);
// The same of a table that a program made, which needs no sheet.
FitResult fit(const io::SampleTable& table, const std::vector<std::vector<Reflectance>>& models,
              const FitOptions& options, const Progress& progress = {},
              const RefitSolutions* refits = nullptr);
// Of what is prepared, with options that differ from its own in starts and ties at most.
FitResult fit(const Prepared& prepared, const std::vector<std::vector<Reflectance>>& models,
              const FitOptions& options, const Progress& progress = {},
              const RefitSolutions* refits = nullptr);

// How many refits a fit has: the folds of a cross-validation and the bootstrap's replicates, of each model.
std::size_t count_refits(const io::SampleTable& table, std::size_t models, const FitOptions& options);
// Those with the numbers from `first` on, those of the first model before those of the second: bit by bit
// what fit() solves. The models they are of are fitted before. None where the run is interrupted.
RefitSolutions solve_refits(const io::SampleTable& table, const std::vector<std::vector<Reflectance>>& models,
                            const FitOptions& options, std::size_t first, std::size_t count);

// The canonical forms, or all that can be fitted.
std::vector<std::vector<Reflectance>> canonical_models();
std::vector<std::vector<Reflectance>> every_model();

}  // namespace brdf::fit
