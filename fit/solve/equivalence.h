// Detects equivalent solutions: parameters with the same meaning, and minima without a barrier between
// them.
#pragma once

#include "fit/solve/minima.h"

namespace brdf::fit {

// Converts equivalent parameters to one canonical form: the tangent in (-45, 45] degrees, the narrower of
// two equal lobes first.
void canonicalise(const Model& model, Minimum& m);

// Returns whether two starts that ended at the same cost in different places found one minimum. They did if
// no barrier separates them, as for a parameter that the samples do not constrain. Otherwise they are two
// solutions.
bool same_minimum(const SampleStream& stream, const Minimum& a, const Minimum& b);

}  // namespace brdf::fit
