// Materials as shader source (GLSL 4.50 for Vulkan, GLSL ES 3.00 for WebGL 2).
#pragma once

#include <string>

#include "brdf/material.h"

namespace brdf::io {

struct GlslContent {
  // brdf_material(wi, wo) with the parameters as constants, beside the forms' functions.
  bool material = true;
  // A shader that compiles as it is: #version and an empty main().
  bool whole = true;
  GlslDialect dialect = GlslDialect::vulkan;
  // exp, log and the rest by GLSL's own functions: to be read, and for scalars other than float; not the library's bits.
  bool builtin_kernels = false;
};

// Throws InputError where a reflectance has no GLSL, and for a material function of channels that are no colours
// (io/channel_colours.h).
std::string glsl_source(const Material& material, const GlslContent& content = {});

// A finite number rounded to float, as GLSL spells it: "0.5", "2.0".
std::string glsl_number(double value);

}  // namespace brdf::io
