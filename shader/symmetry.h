// Whether a shader's function can change when light and viewer turn together about the normal.
#pragma once

#include "shader/function.h"

namespace brdf::shader {

// Every value is followed as a polynomial of degree two at most in Lx, Ly, Vx, Vy (the coordinates across the
// normal), whose coefficients do not change with the turn. A polynomial with equal coefficients of LxLx and
// LyLy, of VxVx and VyVy, of LxVx and LyVy, opposite ones of LxVy and LyVx, and no other term depends on dot
// products and on the cross product along the normal alone, so it does not change either. Anything else that
// reaches the result, a comparison or an index ends the argument. Coefficients are equal where the same
// operations on the same numbers make them.
Symmetry symmetry_of(const Program& program, const std::vector<Binding>& bindings);

}  // namespace brdf::shader
