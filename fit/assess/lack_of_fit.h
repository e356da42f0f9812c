// How wrong a model is, whatever its verdict: where, and how far its parameters depend on it.
#pragma once

#include <optional>
#include <span>

#include "fit/assess/result.h"
#include "fit/solve/sample_stream.h"

namespace brdf::fit {

// The residual against the noise (relative), and the cell of half angles with the largest mean loss among
// those with eight rows or more. Where the noise is not known nothing is beyond it. `model`: its values
// [channel][row].
LackOfFit lack_of_fit(const SampleStream& stream, const std::vector<std::vector<double>>& model,
                      std::optional<double> noise);

// The solver's parameters as the other metrics have them, from the solution on all rows. A robust loss keeps
// its kind, its scale is estimated again.
std::vector<std::vector<double>> under_other_metrics(const SampleStream& stream,
                                                     std::span<const double> solution,
                                                     const FitOptions& options);

// Fills in how far the free parameters move. The interval with lack of fit is the jackknife's over folds
// (Bell and McCaffrey 2002, CR3, groups of incidences as clusters), its bias within the error, Student's t
// with the degrees of freedom that the folds' kurtosis leaves (Satterthwaite 1946): it holds where the
// model's error is shared within an incidence, and incidences could have been others. What no incidence sees,
// an error that all share, is not in it.
void add_movement(const Model& model, std::span<const double> solution,
                  const std::vector<std::vector<double>>& folds,
                  const std::vector<std::vector<double>>& metrics, std::vector<Estimate>& estimates);

}  // namespace brdf::fit
