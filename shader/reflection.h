// Whether a shader's function is symmetric about the tangent and about the bitangent.
#pragma once

#include "shader/function.h"

namespace brdf::shader {

// The value stays, bit for bit, when the tangent's coordinates of light and viewer change their sign
// together, and when the bitangent's do. Every value is followed as even or odd in that sign; a comparison,
// an index or a result that is not even ends the argument. Where this is false, nothing is known.
bool reflects(const Program& program, const std::vector<Binding>& bindings);

}  // namespace brdf::shader
