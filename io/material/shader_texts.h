// Writes the formulas in languages that differ from GLSL only in their keywords: HLSL, C++, and the files
// of Disney's BRDF Explorer.
#pragma once

#include <string>

#include "brdf/material.h"
#include "io/material/shader_language.h"

namespace brdf::io {

// Returns the functions of the forms and, if `with_material`, the function brdf_material(wi, wo) with the
// parameters of `material`. Without it, a file of the Explorer has sliders for the parameters. `name` is
// the suffix of the function in HLSL and the namespace in C++. Kernels, conventions and errors are the same
// as for glsl_source() (io/material/glsl.h).
std::string shader_text(const Material& material, ShaderLanguage language, bool with_material,
                        const std::string& name, bool builtin_kernels = false);

}  // namespace brdf::io
