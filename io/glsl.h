// Materials as shader source (GLSL 4.50, Vulkan).
#pragma once

#include <string>

#include "brdf/material.h"

namespace brdf::io {

struct GlslContent {
  // brdf_material(wi, wo) with the parameters as constants, beside the forms' functions.
  bool material = true;
  // A shader that compiles as it is: #version and an empty main().
  bool whole = true;
};

// Throws InputError where a reflectance has no GLSL, and for a material function of other than 1 or 3 channels or with
// shapes per channel.
std::string glsl_source(const Material& material, const GlslContent& content = {});

}  // namespace brdf::io
