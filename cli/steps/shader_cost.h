// What an evaluation of a user's shader costs, beside the catalogue's forms as shaders.
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
  std::size_t operations =
      0;                 // on single numbers, calls inlined; both ways of a branch are counted, a loop once
  double driver_ns = 0;  // per evaluation in float, of 4096 at a time, the best of some runs
};

// The shader first, then every form by its exported GLSL, cheapest operations first. `shader` has room for
// the renderer's arguments.
std::vector<ShaderCost> shader_costs(render::Device& device, const Reflectance& shader,
                                     const std::string& name, std::size_t operations);

}  // namespace brdf::cli
