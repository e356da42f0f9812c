// The fits in the viewer's window. The rendering and fitting libraries do not depend on each other.
#pragma once

#include "render/viewer/by_hand.h"

namespace brdf::cli {

// Returns a solver that uses the `fit` of this build with default options. Without `fit`, the solver has no
// functions.
render::Solver solver_beside();
// Returns the median of |material - measured|/measured over all values of the table above 0. The material is
// averaged over the detector's field if the table states its width. NaN in a build without fits, or if the
// channels differ.
double median_deviation(const Material& material, const io::SampleTable& table);

}  // namespace brdf::cli
