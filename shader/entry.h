// Which of a file's functions is the reflectance.
#pragma once

#include <string>
#include <vector>

#include "shader/front/compile.h"
#include "shader/front/source.h"
#include "shader/results.h"
#include "shader/spirv/module.h"

namespace brdf::shader {

struct Chosen {
  const spirv::Function* function = nullptr;
  Results results;        // which of its values are the reflectance
  std::string note = {};  // why that one, where the file does not say; may be empty
};

// The one that `entry` names; else the only one called brdf or BRDF; else the only one that takes directions
// and that no other one calls. Of several of one name the one whose arguments `entry` names, else the only
// one that no other one calls. Throws InputError that lists what there is.
Chosen choose_entry(const spirv::Module& module, const Source& source, const Compiled& compiled);

// Global variables that are directions by their names and that the text declares without a value: what a file
// around this one would set.
std::vector<std::string> free_directions(const spirv::Module& module, const Source& source);

// "vec3 brdf(vec3 L, vec3 V, float roughness)", for messages.
std::string signature(const spirv::Module& module, const spirv::Function& function);

}  // namespace brdf::shader
