// Materials as shader source (GLSL 4.50 for Vulkan, GLSL ES 3.00 for WebGL 2).
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "brdf/material.h"

namespace brdf::io {

struct GlslContent {
  // brdf_material(wi, wo) with the parameters as constants, beside the forms' functions.
  bool material = true;
  // A shader that compiles as it is: #version and an empty main().
  bool whole = true;
  GlslDialect dialect = GlslDialect::vulkan;
  // exp, log and the rest by GLSL's own functions: to be read, and for scalars other than float; not the
  // library's bits.
  bool builtin_kernels = false;
  // The function's name is brdf_material_NAME; empty and not guarded: brdf_material.
  std::string name = {};
  // Of functions only: several texts can stand in one shader. Kernels and forms are taken from the first,
  // each material has its own function, and while there is one material, brdf_material is it too.
  bool guarded = false;
};

// What a source is put together from.
struct GlslParts {
  std::string head;                                        // comments
  std::string kernels;                                     // what every form takes
  std::vector<std::pair<std::string, std::string>> forms;  // name, functions
  std::string material;                                    // its function; empty without
};

GlslParts glsl_parts(const Material& material, const GlslContent& content = {});

// Throws InputError where a reflectance has no GLSL, and for a material function of channels that are no
// colours (io/colour/channel_colours.h).
std::string glsl_source(const Material& material, const GlslContent& content = {});

// Tells texts apart: of 28 bits, so that every preprocessor takes it for an int.
std::string text_number(const std::string& text);
// The text behind an include guard, which holds a number of the text: the same text again is left out,
// another under the same macro ends the compilation with this sentence. None is needed where the macro itself
// holds the text's number.
std::string guarded(const std::string& macro, const std::string& text, const std::string& clash);

// A finite number rounded to float, as GLSL spells it: "0.5", "2.0".
std::string glsl_number(double value);

}  // namespace brdf::io
