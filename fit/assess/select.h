// Choosing between models.
#pragma once

#include <span>

#include "fit/assess/result.h"
#include "fit/model/data.h"
#include "fit/model/model.h"
#include "fit/solve/residual.h"

namespace brdf::fit {

struct CrossValidation {
  double error = 0;           // median relative error of rows left out, all folds together
  double standard_error = 0;  // of that, from the scatter between folds
};

// Five folds that leave out whole directions of incidence (where there are at least five): a model must
// predict angles it has not seen. Each fold is solved from the solution on all rows.
CrossValidation cross_validate(const FitData& data, const Model& model, const Residual& residual,
                               std::span<const double> solution, const FitOptions& options);

// Sorts best first by error; equal errors (three digits) by
// verdict, then by number of parameters. Sets `recommended`.
void rank(FitResult& result);

}  // namespace brdf::fit
