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

// One number, truth value or colour among the values that a function gives. The name is empty for the
// returned value; members of structs are named as in the source: "material.roughness".
struct Leaf {
  std::string name;
  ResultPart part;
  bool truth = false;
  // The part is the first three components of a vec4.
  bool of_four = false;
};
// The values that a function returns or writes: numbers, truth values, and vectors of three or four numbers.
struct Given {
  std::vector<Leaf> values;
  std::set<int> written, accumulated;  // as in Results
};
Given given_values(const spirv::Module& module, const spirv::Function& function, const Source& source);

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
