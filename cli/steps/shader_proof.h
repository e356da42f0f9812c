// The comparison of shaders with the float library in `brdf validate`.
#pragma once

#include <cstdint>
#include <span>

#include "brdf/material.h"
#include "cli/options/shader_options.h"
#include "cli/verb.h"

namespace brdf::cli {

// Runs `brdf validate --gpu`: compares each form on 2^20 random configurations and the extremes, and prints
// a table or JSON on stdout. Returns Exit::failed if a software driver differs in any bit, or if a hardware
// device differs by more than the tolerance. Throws EnvironmentError if there is no Vulkan driver or if this
// build has no renderer.
// With `shader` (`--shader FILE --gpu`), compares the user's function with its float interpreter, which
// rounds every operation correctly. Differences then come from the driver's pow, acos and similar functions
// and are not faults of the shader; the result is always Exit::good. The cost of an evaluation, compared
// with the forms, is printed below.
Exit validate_gpu(std::span<const Reflectance> forms, std::uint64_t seed, bool json,
                  const LoadedShader* shader = nullptr);
// Returns the reflectance with room for the shaders' arguments (render/gpu/held.h).
Reflectance with_room(const Material& material);

}  // namespace brdf::cli
