// Materials with a user's shader as their form.
#pragma once

#include "brdf/reflectance.h"

namespace brdf::shader {

class ShaderReflectance;

// Enables shaders in materials: from now on written materials refer to shaders (docs/formats.md), and
// materials with shaders can be read. Call it once per process.
void use_in_materials();

// Returns the shader behind a reflectance; null if the reflectance is not a shader.
const ShaderReflectance* shader_of(const Reflectance& reflectance);

}  // namespace brdf::shader
