// Chooses the function of a file that is the reflectance.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "shader/front/compile.h"
#include "shader/front/source.h"
#include "shader/results.h"
#include "shader/spirv/module.h"

namespace brdf::shader {

struct Chosen {
  const spirv::Function* function = nullptr;
  Results results;        // the values of the function that are the reflectance
  std::string note = {};  // the reason of the choice, if the file does not name the function; may be empty
};

// Returns the function that `entry` names; otherwise the only function with the name brdf or BRDF;
// otherwise the only function that takes directions and is not called by another function. Among several
// functions with the same name, returns the one with the arguments that `entry` names, or otherwise the
// only one that is not called by another function and takes directions. Throws InputError, with a list of
// the functions, if the choice is not unique.
Chosen choose_entry(const spirv::Module& module, const Source& source, const Compiled& compiled);

// Returns the global variables that are directions according to their names and that the text declares
// without a value. A file that includes this one would set them.
std::vector<std::string> free_directions(const spirv::Module& module, const Source& source);

// Returns the functions that the file defines, without main functions and without the functions that the
// program adds.
std::vector<const spirv::Function*> own_functions(const spirv::Module& module);
// Returns the functions that functions other than main functions call. `by_samplers` false: calls by samplers
// and densities do not count.
std::set<spirv::Id> called_by_others(const spirv::Module& module, bool by_samplers = true);
// Returns the type to which a pointer type points; other types unchanged.
spirv::Id pointee(const spirv::Module& module, spirv::Id type);

// Returns "vec3 brdf(vec3 L, vec3 V, float roughness)", for messages.
std::string signature(const spirv::Module& module, const spirv::Function& function);

}  // namespace brdf::shader
