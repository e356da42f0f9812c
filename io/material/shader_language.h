// The languages of exported shaders, and the functions that a user's shader writes in them.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "brdf/reflectance.h"

namespace brdf::io {

enum class ShaderLanguage {
  glsl,      // GLSL 4.50 of Vulkan
  glsl_es,   // GLSL ES 3.00 of WebGL 2
  explorer,  // GLSL 4.10 in a .brdf file: parameters as sliders, vec3 BRDF(L, V, N, X, Y)
  hlsl,      // shader model 5: `precise`, asuint and asfloat
  cpp,       // C++17 in float, a header
};

// A reflectance with operations that the languages spell differently. A form of the library has none: its
// GLSL is translated word by word.
class SpeaksLanguages {
 public:
  virtual ~SpeaksLanguages() = default;
  // Returns the functions of ReflectanceModel::glsl() for this language. The operations are written in the
  // language. Types (vec3), literals and the functions that forms use are those of GLSL, and are translated
  // with the text around them.
  virtual std::string functions_in(ShaderLanguage language) const = 0;
};

// Returns the names of a reflectance's parameters as the arguments of its exported functions: the shape,
// then the weights. A name that a language reserves, or that occurs twice, gets another one. All texts,
// annotations and sliders use these names.
std::vector<std::string> argument_names(std::span<const ParameterInfo> shape,
                                        std::span<const ParameterInfo> weights);

}  // namespace brdf::io
