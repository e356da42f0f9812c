// The verdict on a solution.
#pragma once

#include <optional>
#include <vector>

#include "fit/assess/assess.h"

namespace brdf::fit {

// Sets linear unknowns to exactly 0, and holds them there, if their lobe adds next to nothing. Returns the
// normal equations before this change. `besides`, if not null, receives the values of the model after the
// change.
NormalEquations drop_negligible_lobes(const SampleStream& stream, Minimum& m, Besides* besides = nullptr);

// Judges whether the model deviates systematically from the surface. `values` are the values of the model,
// `noise` is the relative noise of the measured values, std::nullopt if unknown. Lower noise never turns a
// misfit into a good fit.
Misfit judge(const FitData& data, const std::vector<std::vector<double>>& values,
             std::optional<double> noise);

// Returns the verdict that follows from the minimum, its uncertainty and the misfit test.
Verdict verdict_of(const Minimum& m, const Uncertainty& u, const Misfit& misfit);

}  // namespace brdf::fit
