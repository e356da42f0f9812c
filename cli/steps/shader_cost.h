// The cost of an evaluation of a user's shader, compared with the catalogue's forms as shaders.
#pragma once

#include <string>
#include <vector>

#include "brdf/material.h"
#include "cli/options/shader_options.h"

namespace brdf::render {
class Device;
}

namespace brdf::cli {

struct ShaderCost {
  std::string name;
  // Operations on single numbers, with calls inlined. Both sides of a branch count, and a loop counts once.
  std::size_t operations = 0;
  // Nanoseconds per evaluation in float, measured on batches of 4096; the best of several runs.
  double driver_ns = 0;
};

// Returns the cost of the shader first, then of every form by its exported GLSL, in ascending order of
// operations. `shader` must have room for the renderer's arguments.
std::vector<ShaderCost> shader_costs(render::Device& device, const Reflectance& shader,
                                     const std::string& name, std::size_t operations);

}  // namespace brdf::cli
