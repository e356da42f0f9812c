// SPIR-V of the shaders in render/shaders, compiled at build time, and the sources of those that are compiled
// again at run time.
#pragma once

#include "render/vulkan/pipeline.h"

namespace brdf::render::shader_code {

Spirv mesh_vertex();
Spirv screen_vertex();
Spirv gbuffer();
Spirv lighting();
Spirv forward();
Spirv sky();
Spirv classic_vertex();
Spirv classic();
Spirv display();
Spirv proof();
Spirv copy();

// Without brdf.glsl (see FragmentCode).
extern const char* const lighting_text;
extern const char* const forward_text;

}  // namespace brdf::render::shader_code
