// Writes a shader's function as text, from its flattened program, so that the renderer can draw a shader of
// any source language, and that it can be exported in other languages.
#pragma once

#include <string>
#include <vector>

#include "io/material/shader_language.h"
#include "shader/function.h"

namespace brdf::shader {

// Returns the reason why the function cannot be written, in words that follow its name; "" if it can be
// written. Programs with very many operations, and with variably indexed arrays of very many elements,
// cannot be written.
std::string glsl_obstacle(const Function& function);

struct Wording {
  io::ShaderLanguage language = io::ShaderLanguage::glsl;
  bool precise = true;                      // marks numbers as `precise` if the language has the word
  std::vector<std::string> arguments = {};  // io::argument_names() of the tables
};

// Returns the functions brdf_eval_<name> and brdf_eval_cos_<name> (brdf/reflectance.h), as the text of
// io::SpeaksLanguages. Their arguments are the function's parameters with the numbers `shape`, as floats, and
// with the numbers `weights`, as vec3. Every operation is the interpreter's operation, except that exp, pow
// and similar functions are the driver's or the C++ library's. A loop ends after 4096 iterations.
std::string glsl_of(const Function& function, const std::string& name,
                    const std::vector<std::size_t>& weights, const std::vector<std::size_t>& shape,
                    const Wording& wording);

}  // namespace brdf::shader
