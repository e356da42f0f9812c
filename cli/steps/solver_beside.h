// The fits that the window borrows: rendering and fitting know nothing of each other.
#pragma once

#include "render/viewer/by_hand.h"

namespace brdf::cli {

// With this build's `fit`, by its default choices; without it a solver that can do nothing.
render::Solver solver_beside();

}  // namespace brdf::cli
