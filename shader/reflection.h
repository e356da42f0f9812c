// Determines whether a shader's function is symmetric about the tangent and about the bitangent.
#pragma once

#include "shader/function.h"

namespace brdf::shader {

// Returns true if the value is unchanged, bit for bit, when the tangent coordinates of light and viewer
// change their sign together, and when the bitangent coordinates do. Every value is classified as even or
// odd in that sign. A comparison, an index or a result that is not even ends the proof. If false, nothing
// is known.
bool reflects(const Program& program, const std::vector<Binding>& bindings);

}  // namespace brdf::shader
