// From a SPIR-V module to a flattened program.
#pragma once

#include <functional>
#include <set>
#include <string>
#include <vector>

#include "shader/program/program.h"
#include "shader/spirv/module.h"

namespace brdf::shader {

// Scalars `first` to `first + count - 1` of what the function returns (argument -1) or of an argument that it
// writes; count is 1 or 3.
struct ResultPart {
  int argument = -1;
  std::size_t first = 0, count = 0;
};

struct LowerOptions {
  // Global variables that are parameters (others keep their initial value).
  std::set<std::string> parameters = {};
  // The library's kernels, where an exported shader holds them, by their meaning and not by their bits: for
  // scalars that are no float.
  bool kernels_by_meaning = false;
  std::size_t most_steps = 200'000;      // of the program
  std::vector<ResultPart> results = {};  // their sum is the value; empty: what is returned
  std::set<int> written = {};            // arguments that are no inputs
  std::set<int> accumulated = {};        // of those: the ones that are `inout` and hold 0 before
  bool zero_globals = false;             // the language gives 0 to global variables without a value (HLSL)
};

// Throws InputError, with the line, for what a reflectance cannot have (textures, derivatives of the screen,
// discard), and where the program would be larger than allowed.
Program lower(const spirv::Module& module, const spirv::Function& entry, const LowerOptions& options = {});

// Whether the module holds kernels that mean more than their bits.
bool holds_kernels(const spirv::Module& module);

// Removes what no result needs.
void remove_unused(Program& program);

}  // namespace brdf::shader
