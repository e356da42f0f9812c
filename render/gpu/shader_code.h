// SPIR-V of the shaders in render/shaders, compiled at build time.
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
Spirv probe();
Spirv copy();

}  // namespace brdf::render::shader_code
