// Which solutions are one: parameters that mean the same, and minima that nothing stands between.
#pragma once

#include "fit/solve/minima.h"

namespace brdf::fit {

// Writes equivalent parameters one way: the tangent in (-45, 45] degrees, the narrower of two equal lobes
// first.
void canonicalise(const Model& model, Minimum& m);

// Starts that end at the same cost in different places are one minimum where nothing stands between them, as
// on a parameter that the samples do not see; else they are two answers.
bool same_minimum(const SampleStream& stream, const Minimum& a, const Minimum& b);

}  // namespace brdf::fit
