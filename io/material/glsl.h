// Writes materials as shader source (GLSL 4.50 for Vulkan, GLSL ES 3.00 for WebGL 2).
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "brdf/material.h"
#include "io/material/shader_language.h"

namespace brdf::io {

struct GlslContent {
  // Includes brdf_material(wi, wo), with the parameters as constants, in addition to the functions of the
  // forms.
  bool material = true;
  // Writes a complete shader that compiles: with #version and an empty main().
  bool whole = true;
  GlslDialect dialect = GlslDialect::vulkan;
  // Uses GLSL's own exp, log and other functions, for readability and for scalars other than float. The
  // values are then not bit-identical to the library's.
  bool builtin_kernels = false;
  // Names the function brdf_material_NAME. If `name` is empty and `guarded` is false, the function is
  // brdf_material.
  std::string name = {};
  // Writes functions only, so several texts can be part of one shader. Kernels and forms are taken from the
  // first text. Each material has its own function; as long as there is only one material, brdf_material
  // also refers to it.
  bool guarded = false;
  // The language into which the text is translated afterwards (io/material/shader_texts.h).
  std::optional<ShaderLanguage> translated = {};
};

// The parts from which a source is assembled.
struct GlslParts {
  std::string head;                                        // comments
  std::string kernels;                                     // functions that every form uses
  std::vector<std::pair<std::string, std::string>> forms;  // name, functions
  std::string material;                                    // its function; empty if not requested
};

// Returns the parts of the source of `material`. Throws as glsl_source() does.
GlslParts glsl_parts(const Material& material, const GlslContent& content = {});

// Returns the source of `material`. Throws InputError if a reflectance has no GLSL, or if brdf_material is
// requested for channels that are not colours (io/colour/channel_colours.h).
// Example:
//     // #include "brdf/io/material/material_file.h"
//     const brdf::Material copper = brdf::io::read_material("copper.json");
//     brdf::io::GlslContent content;
//     content.dialect = brdf::GlslDialect::es;  // WebGL 2
//     const std::string shader = glsl_source(copper, content);
std::string glsl_source(const Material& material, const GlslContent& content = {});

// Returns a number of 28 bits that distinguishes texts. Every preprocessor accepts such a number as an int.
std::string text_number(const std::string& text);
// Returns the text in an include guard that holds a number of the text. The same text is then skipped when
// repeated; another text under the same macro stops the compilation with the sentence `clash`. `clash` may
// be empty if the macro itself contains the number of the text.
std::string guarded(const std::string& macro, const std::string& text, const std::string& clash);

// Returns a finite number, rounded to float, in the spelling of GLSL: "0.5", "2.0".
std::string glsl_number(double value);

}  // namespace brdf::io
