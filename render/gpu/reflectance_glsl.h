// GLSL around the functions of the reflectances. emit_shaders writes this code for the catalogue when the
// program is built; for other reflectances it is compiled at run time.
#pragma once

#include <string>
#include <vector>

#include "brdf/trace.h"

namespace brdf::render {

// Returns the reflectances of the catalogue that the shaders have room for, numbered by their index. A
// specialisation constant selects one of them, so that the driver keeps a single case.
std::vector<NumberedReflectance> numbered_catalogue();
// Returns the same reflectances without their numbers: the forms that can be drawn with all their parameters.
std::vector<Reflectance> drawable_forms();
// Returns the reason why shaders cannot evaluate this reflectance, worded to follow its name; empty if they
// can.
std::string shader_obstacle(const ReflectanceInfo& info);

inline constexpr unsigned kProofGroup = 64;  // configurations per workgroup of the proof's shader

// Returns the kernels, the functions of each reflectance, and brdf_eval_cos, which selects one by its
// number.
std::string reflectances_glsl(std::span<const NumberedReflectance> list, const GlslOptions& options = {});
// Returns the sampler of each reflectance, and brdf_sample and brdf_pdf, which select one by its number.
// This text must follow that of reflectances_glsl().
std::string samplers_glsl(std::span<const NumberedReflectance> list, const GlslOptions& options = {});
// Returns the compute shader of proof/shader_proof.h, which evaluates one reflectance for many
// configurations.
std::string proof_glsl(std::span<const NumberedReflectance> list, const GlslOptions& options = {});

}  // namespace brdf::render
