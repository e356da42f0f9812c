// Which of a file's functions is the reflectance.
#pragma once

#include <string>
#include <vector>

#include "shader/front/source.h"
#include "shader/spirv/module.h"

namespace brdf::shader {

struct Chosen {
  const spirv::Function* function = nullptr;
  std::string note = {};  // why that one, where the file does not say; may be empty
};

// The one that `entry` names; else the only one called brdf or BRDF; else the only one that takes directions and that no other one
// calls. Throws InputError that lists what there is.
Chosen choose_entry(const spirv::Module& module, const Source& source);

// "vec3 brdf(vec3 L, vec3 V, float roughness)", for messages.
std::string signature(const spirv::Module& module, const spirv::Function& function);

}  // namespace brdf::shader
