// SPIR-V of the shaders in render/shaders, compiled at build time, and the sources of the shaders that are
// compiled again at run time.
#pragma once

#include "render/vulkan/pipeline.h"

namespace brdf::render::shader_code {

extern const Spirv mesh_vertex, screen_vertex, gbuffer, lighting, forward, sky, classic_vertex, classic,
    display, proof, copy, shadow_vertex, shadow, environment, light_points, backdrop, accumulate, mean,
    places, enlarge, paths;

// Sources without brdf.glsl and samplers.glsl (see FragmentCode).
extern const char* const lighting_text;
extern const char* const forward_text;
extern const char* const environment_text;

}  // namespace brdf::render::shader_code
