// The formulas in languages that are GLSL but for their words: HLSL, C++, and Disney's BRDF Explorer.
#pragma once

#include <string>

#include "brdf/material.h"

namespace brdf::io {

enum class ShaderLanguage {
  hlsl,      // shader model 5: `precise`, asuint and asfloat
  cpp,       // C++17 in float, a header (io/material/cpp_text.h)
  explorer,  // a .brdf file: parameters as sliders, vec3 BRDF(L, V, N, X, Y)
};

// The forms' functions, and with `material` the function brdf_material(wi, wo) of these parameters; in the
// Explorer's file without it the parameters are sliders. `name`: of the namespace in C++. Kernels,
// conventions and errors as of glsl_source (io/material/glsl.h).
std::string shader_text(const Material& material, ShaderLanguage language, bool with_material,
                        const std::string& name, bool builtin_kernels = false);

}  // namespace brdf::io
