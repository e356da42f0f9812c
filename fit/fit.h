// Fits reflectance models to samples and estimates the uncertainty of their parameters.
#pragma once

#include <vector>

#include "brdf/reflectance.h"
#include "fit/assess/result.h"
#include "fit/model/options.h"
#include "fit/prepared.h"
#include "fit/samples.h"

namespace brdf::fit {

// The solver's parameters of each refit (fit/assess/refits.h). The vector of a refit is empty if its model
// has no solution.
using RefitSolutions = std::vector<std::vector<double>>;

// Fits each model, which is one form or a sum of several forms. If `models` is empty, fit() builds a model
// step by step (fit/stepwise.h). `progress` is called with the name of each model before the model is
// fitted. `refits` holds the results of solve_refits() for all models; they are reused instead of solved
// again. The result contains the data sheet of the samples, and lack of fit is judged against the noise
// that the data sheet found. Throws InputError if the options are not valid for these models.
// Example:
//     // #include "brdf/io/formats/read.h"
//     brdf::fit::FitOptions options;
//     options.metric = brdf::fit::Metric::automatic;
//     const auto samples = brdf::fit::arranged(brdf::io::read_samples("paint.csv"), options);
//     const auto result = brdf::fit::fit(samples, {{*brdf::find_form("cook_torrance")}}, options);
//     for (const brdf::fit::Estimate& e : result.ranking.front().estimates)
//       std::printf("%s %s: %g (%g to %g)\n", e.name.c_str(), e.channel.c_str(), e.value, e.low, e.high);
FitResult fit(const Samples& samples, const std::vector<std::vector<Reflectance>>& models,
              const FitOptions& options, const Progress& progress = {},
              const RefitSolutions* refits = nullptr);
// Does the same for a table that a program computed, which needs no data sheet.
FitResult fit(const io::SampleTable& table, const std::vector<std::vector<Reflectance>>& models,
              const FitOptions& options, const Progress& progress = {},
              const RefitSolutions* refits = nullptr);
// Does the same for a prepared table. `options` may differ from the options of the preparation only in the
// starting points and in `tie`.
FitResult fit(const Prepared& prepared, const std::vector<std::vector<Reflectance>>& models,
              const FitOptions& options, const Progress& progress = {},
              const RefitSolutions* refits = nullptr);

// Returns the number of refits of a fit: the folds of the cross-validation and the replicates of the
// bootstrap, for each model.
std::size_t count_refits(const io::SampleTable& table, std::size_t models, const FitOptions& options);
// Solves refits `first` to `first + count - 1`, numbered model by model. The results are bit-identical to
// the results inside fit(). Fits the models concerned first. Returns an empty vector if the run is
// interrupted.
RefitSolutions solve_refits(const io::SampleTable& table, const std::vector<std::vector<Reflectance>>& models,
                            const FitOptions& options, std::size_t first, std::size_t count);

// Return the canonical forms, or all forms that can be fitted, each as a model of its own.
std::vector<std::vector<Reflectance>> canonical_models();
std::vector<std::vector<Reflectance>> every_model();

}  // namespace brdf::fit
