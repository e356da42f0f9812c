// GLSL round the reflectances' own functions: what emit_shaders writes for the catalogue when the program is
// built, and what is compiled at run time for one that is not in it.
#pragma once

#include <string>
#include <vector>

#include "brdf/trace.h"

namespace brdf::render {

// Those of the catalogue that the shaders have room for, numbered by their places: a specialisation constant
// picks one, so that the driver keeps one case.
std::vector<NumberedReflectance> numbered_catalogue();
// Why shaders cannot have this reflectance, in words that follow its name; "" where they can.
std::string shader_obstacle(const ReflectanceInfo& info);

inline constexpr unsigned kProofGroup = 64;  // configurations per workgroup of the proof's shader

// Kernels, the functions of each, and brdf_eval_cos, which picks one by its number.
std::string reflectances_glsl(std::span<const NumberedReflectance> list, const GlslOptions& options = {});
// After those: the sampler of each, and brdf_sample and brdf_pdf, which pick one by its number.
std::string samplers_glsl(std::span<const NumberedReflectance> list, const GlslOptions& options = {});
// The compute shader of proof/shader_proof.h: one reflectance on many configurations.
std::string proof_glsl(std::span<const NumberedReflectance> list, const GlslOptions& options = {});

}  // namespace brdf::render
