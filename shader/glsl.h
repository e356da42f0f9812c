// A shader's function as GLSL again, from its flattened program: whatever language it came in, the renderer
// draws it.
#pragma once

#include <string>
#include <vector>

#include "brdf/reflectance.h"
#include "shader/function.h"

namespace brdf::shader {

// Why it cannot be written, in words that follow its name; "" where it can: programs of very many operations,
// and arrays of very many elements at changing places, have none.
std::string glsl_obstacle(const Function& function);

// brdf_eval_<name> and brdf_eval_cos_<name> (brdf/reflectance.h), of arguments that are the function's
// parameters number `shape` as floats and number `weights` as vec3. Every operation is the interpreter's;
// exp, pow and the like are the driver's own. A loop ends after 4096 rounds.
std::string glsl_of(const Function& function, const std::string& name,
                    const std::vector<std::size_t>& weights, const std::vector<std::size_t>& shape,
                    const GlslOptions& options);

}  // namespace brdf::shader
