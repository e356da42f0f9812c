// Which values of a shader's function are the reflectance: what it returns, a member of that, or arguments
// that it writes.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "shader/front/source.h"
#include "shader/program/lower.h"
#include "shader/spirv/module.h"

namespace brdf::shader {

struct Results {
  std::vector<ResultPart> parts;  // their sum is the reflectance; empty: there is none
  std::set<int> written;          // arguments that are no inputs
  std::set<int> accumulated;      // of those: the ones that are declared as `inout`
  std::string note;               // which they are, where the function has more than one; may be empty
  std::string several;            // what it has, where nothing says which; else empty
  bool named = false;             // a name says that it is reflected light
};

// A float, a vec3 or the first three of a vec4; of several the one that its name tells (response, color, f,
// ...), or diffuse and specular ones together. Arguments are written that the text says are `out` or `inout`;
// of a void function without such a text the last one.
Results results_of(const spirv::Module& module, const spirv::Function& function, const Source& source);

}  // namespace brdf::shader
