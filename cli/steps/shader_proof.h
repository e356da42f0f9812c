// The comparison of shaders with the float library in `brdf validate`.
#pragma once

#include <cstdint>
#include <span>

#include "brdf/material.h"
#include "cli/options/shader_options.h"
#include "cli/verb.h"

namespace brdf::cli {

// `brdf validate --gpu`: each form on 2^20 random configurations and the extremes, as a table or as JSON on
// stdout. kFailed where a software driver differs in any bit, or a hardware device by more than the
// tolerance. Throws EnvironmentError where there is no Vulkan driver or this build has no renderer. `--shader
// FILE --gpu`: the same of the user's function, whose float interpreter rounds every operation correctly.
// What differs is the driver's pow, acos and the like, no fault of the shader: always kGood. Below it, what
// an evaluation costs beside the forms.
Exit validate_gpu(std::span<const Reflectance> forms, std::uint64_t seed, bool json,
                  const LoadedShader* shader = nullptr);
// The reflectance with room for the shaders' arguments (render/gpu/held.h).
Reflectance with_room(const Material& material);

}  // namespace brdf::cli
