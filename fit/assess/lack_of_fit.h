// Measures of systematic error of a model, whatever its verdict: the location of the error, and the
// sensitivity of the parameters to it.
#pragma once

#include <optional>
#include <span>

#include "fit/assess/result.h"
#include "fit/solve/sample_stream.h"

namespace brdf::fit {

// Limit of the residual over a noise that is itself known to a factor of 1.5 at best.
inline constexpr double kBeyond = 1.3;

// Compares the residual with the noise (relative), and finds the cell of half angles with the largest mean
// loss among the cells with at least eight rows. If the noise is unknown, no residual counts as beyond the
// noise. `model` holds the values of the model, [channel][row].
LackOfFit lack_of_fit(const SampleStream& stream, const std::vector<std::vector<double>>& model,
                      std::optional<double> noise);

// Returns the solver's parameters under each of the other metrics, solved from the solution on all rows. A
// robust loss keeps its kind, and its scale is estimated again.
std::vector<std::vector<double>> under_other_metrics(const SampleStream& stream,
                                                     std::span<const double> solution,
                                                     const FitOptions& options);

// Fills in the movement of the free parameters. The interval with lack of fit is the interval of a
// jackknife over folds (Bell and McCaffrey 2002, CR3, with groups of incidences as clusters). Its error
// includes the bias, and it uses Student's t with the degrees of freedom that follow from the kurtosis of
// the folds (Satterthwaite 1946). The interval is valid if the error of the model is shared within an
// incidence, and if other incidences could have been measured. An error that all incidences share is not
// included, because no incidence reveals it.
void add_movement(const Model& model, std::span<const double> solution,
                  const std::vector<std::vector<double>>& folds,
                  const std::vector<std::vector<double>>& metrics, std::vector<Estimate>& estimates);

}  // namespace brdf::fit
