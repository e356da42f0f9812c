// Solves a model again on a different set of rows: without one fold, or on rows drawn from all rows.
//
// Each refit starts from the solution on all rows and is independent of the other refits, so any of them
// can be computed from that solution alone. The normal equations of a refit are sums over groups of rows
// (data.groups): the groups of the kept folds, or the groups that were drawn, each as often as it was
// drawn.
#pragma once

#include <span>
#include <vector>

#include "fit/assess/result.h"
#include "fit/solve/sample_stream.h"

namespace brdf::fit {

// Returns the number of held-out folds: all folds if cross-validation is requested and there are at least
// two, otherwise 0.
std::size_t count_folds(const RowGroups& groups, const FitOptions& options);
// Returns the number of folds plus the number of bootstrap replicates. There are no replicates of fewer
// than two groups.
std::size_t count_refits(const RowGroups& groups, const FitOptions& options);

// Returns the solver's parameters of refit number k. The folds come first, then the replicates. Each
// replicate draws as many groups as there are, with replacement (Efron and Tibshirani 1993, section 8.3:
// the unit of resampling is the independent unit). The random numbers depend only on the seed and on the
// number of the replicate.
std::vector<double> refit(const SampleStream& all, std::span<const double> solution, std::size_t k,
                          const FitOptions& options);

// Fills in the statistics of the replicates for the free parameters: their standard deviation, and the
// interval between their 2.5 % and 97.5 % quantiles (the percentile interval, section 13.3). Does nothing
// if there are fewer than two replicates.
void add_bootstrap(const Model& model, std::span<const std::vector<double>> replicates,
                   std::vector<Estimate>& estimates);

}  // namespace brdf::fit
