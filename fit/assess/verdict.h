// The one word for a solution.
#pragma once

#include <optional>
#include <vector>

#include "fit/assess/assess.h"

namespace brdf::fit {

// Linear unknowns whose lobe adds next to nothing become exactly 0 and are held there. Returns the normal
// equations before that; `besides` has the values after it.
NormalEquations drop_negligible_lobes(const SampleStream& stream, Minimum& m, Besides* besides = nullptr);

// Whether the model does something else than the surface; `values` are the model's, `noise` the values'
// relative scatter, none where it is not known (less noise never makes a misfit good).
Misfit judge(const FitData& data, const std::vector<std::vector<double>>& values,
             std::optional<double> noise);

Verdict verdict_of(const Minimum& m, const Uncertainty& u, const Misfit& misfit);

}  // namespace brdf::fit
