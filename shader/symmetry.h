// Determines whether a shader's function can change when light and viewer rotate together about the normal.
#pragma once

#include "shader/function.h"

namespace brdf::shader {

// Returns the facts about such rotations that can be proved. Every value is represented as a polynomial of
// degree at most two in Lx, Ly, Vx, Vy (the coordinates across the normal), with coefficients that do not
// change with the rotation.
//
// A polynomial depends only on dot products and on the cross product along the normal, and therefore does
// not change either, if it satisfies these conditions: equal coefficients of LxLx and LyLy, of VxVx and
// VyVy, and of LxVx and LyVy; opposite coefficients of LxVy and LyVx; no other term. Any other value that
// reaches the result, a comparison or an index ends the proof. Coefficients count as equal if they result
// from the same operations on the same numbers.
Symmetry symmetry_of(const Program& program, const std::vector<Binding>& bindings);

}  // namespace brdf::shader
