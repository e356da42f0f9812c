// A shader's sampler and density as the interface that judges know.
#pragma once

#include <memory>

#include "brdf/direction_sampler.h"
#include "shader/shader.h"

namespace brdf::shader {

// Returns the sampler and the density of the shader's file; null if the file has neither.
std::shared_ptr<const DirectionSampler> sampler_of(std::shared_ptr<const ShaderReflectance> model);

}  // namespace brdf::shader
