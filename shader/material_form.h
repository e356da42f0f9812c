// Materials whose form is a user's shader.
#pragma once

#include "brdf/reflectance.h"

namespace brdf::shader {

class ShaderReflectance;

// From now on materials name shaders (docs/formats.md), and those that do are read. Once per process.
void use_in_materials();

// The shader behind a reflectance; null: it is none.
const ShaderReflectance* shader_of(const Reflectance& reflectance);

}  // namespace brdf::shader
