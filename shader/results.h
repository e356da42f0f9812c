// Determines which values of a shader's function are the reflectance: the returned value, a member of it,
// or arguments that the function writes.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "shader/front/source.h"
#include "shader/program/lower.h"
#include "shader/spirv/module.h"

namespace brdf::shader {

struct Results {
  std::vector<ResultPart> parts;  // their sum is the reflectance; empty: the function gives no reflectance
  std::set<int> written;          // arguments that are not inputs
  std::set<int> accumulated;      // subset of `written` that is declared as `inout`
  std::string note;               // names the parts if the function gives more than one value; may be empty
  std::string several;            // lists the values if the choice is ambiguous; empty otherwise
  bool named = false;             // a name identifies reflected light
};

// Returns the parts of the reflectance. A part is a float, a vec3 or the first three components of a vec4.
// Among several values the name decides (response, color, f, ...); diffuse and specular values are taken
// together. The written arguments are the arguments that the text declares as `out` or `inout`; for a void
// function without such declarations the last argument.
Results results_of(const spirv::Module& module, const spirv::Function& function, const Source& source);

}  // namespace brdf::shader
