// A model solved again on other rows than all: without a fold, or on rows drawn from them.
//
// Each refit is solved from the solution on all rows and knows of no other, so that whoever has the solution
// can do any of them. Its normal equations are sums over groups of rows (data.groups): those of the folds
// that are kept, or the groups that were drawn, as often as they were.
#pragma once

#include <span>
#include <vector>

#include "fit/assess/result.h"
#include "fit/solve/sample_stream.h"

namespace brdf::fit {

// Folds that are left out: all where cross-validation is asked for, unless there are fewer than two.
std::size_t count_folds(const RowGroups& groups, const FitOptions& options);
// Those, and the bootstrap's replicates; of fewer than two groups there are none.
std::size_t count_refits(const RowGroups& groups, const FitOptions& options);

// The solver's parameters of refit number k: of the folds first, then of the replicates, each of which draws
// as many groups as there are with replacement (Efron and Tibshirani 1993, section 8.3: the unit of
// resampling is what is independent), by random numbers that follow from the seed and its number alone.
std::vector<double> refit(const SampleStream& all, std::span<const double> solution, std::size_t k,
                          const FitOptions& options);

// Fills in what the replicates say of the free parameters: their standard deviation, and the interval between
// their 2.5 % and 97.5 % quantiles (the percentile interval, section 13.3). Nothing where there are fewer
// than two.
void add_bootstrap(const Model& model, std::span<const std::vector<double>> replicates,
                   std::vector<Estimate>& estimates);

}  // namespace brdf::fit
