// The noise of a reading and the error of a model, from the residuals of a fit.
#pragma once

#include <optional>

#include "fit/design/design_rows.h"
#include "fit/design/expected.h"

namespace brdf::fit {

// Estimates what is not known by restricted likelihood (Patterson and Thompson 1971): the residuals are
// independent noise plus a Gaussian process with the correlation of the places. An error counts as detected
// if it raises the logarithm of the likelihood by more than 2.7, which noise alone does in about one table
// out of a hundred. `residuals` are ln(measured) - ln(model), [channel][row]; rows that are not usable are
// left out. Throws InputError, beginning with `source`, if the noise is unknown and cannot be estimated.
NoiseAndError noise_and_error(const DesignRows& rows, const std::vector<std::vector<double>>& residuals,
                              const std::string& source, std::optional<double> noise,
                              std::optional<double> error);

}  // namespace brdf::fit
