// The fits in the viewer's window. The rendering and fitting libraries do not depend on each other.
#pragma once

#include "render/viewer/by_hand.h"

namespace brdf::cli {

// Returns a solver that uses the `fit` of this build with default options. Without `fit`, the solver has no
// functions.
render::Solver solver_beside();

}  // namespace brdf::cli
