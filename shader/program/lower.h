// Converts a SPIR-V module to a flattened program.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "shader/program/program.h"
#include "shader/spirv/module.h"

namespace brdf::shader {

// Scalars `first` to `first + count - 1` of the returned value (argument -1) or of an argument that the
// function writes; count is 1 or 3.
struct ResultPart {
  int argument = -1;
  std::size_t first = 0, count = 0;
};

// The values that are rounded to half precision: none; the values of 16-bit types; also the values that a
// device may compute in 16 bits (RelaxedPrecision: mediump, lowp, min16float).
enum class Halves { none, required, allowed };

struct LowerOptions {
  // Global variables that are parameters; other global variables keep their initial value.
  std::set<std::string> parameters = {};
  // Functions that are kernels of the library in an exported shader. They are treated as the functions that
  // they approximate, not as their operations: for scalars other than float.
  std::set<spirv::Id> by_meaning = {};
  Halves halves = Halves::none;
  std::map<std::string, Texture> textures = {};  // by the names of their variables and arguments
  std::size_t most_steps = 200'000;              // limit of the program's size
  std::vector<ResultPart> results = {};          // their sum is the value; empty: the returned value
  std::set<int> written = {};                    // arguments that are not inputs
  std::set<int> accumulated = {};  // subset of `written` that is `inout` and holds 0 before the call
  bool zero_globals = false;       // the language sets global variables without a value to 0 (HLSL)
  // The results follow one another instead of being added; a truth value becomes 0 or 1. If `random` is not
  // empty, a last result is the number of random numbers that the run has used.
  bool apart = false;
  // Functions that return random numbers. Each call returns the next elements of the input kRandomInput.
  std::set<spirv::Id> random = {};
};

// The input from which calls of random functions are answered, an array of kMostRandom numbers in [0, 1).
inline constexpr const char* kRandomInput = "@random";
inline constexpr std::uint32_t kMostRandom = 32;

// Converts the function to a flattened program. Throws InputError, with the line, for features that a
// reflectance cannot have (textures without a file, screen-space derivatives, discard), and if the program
// would be larger than allowed.
Program lower(const spirv::Module& module, const spirv::Function& entry, const LowerOptions& options = {});

// Returns the first line of a step that rounds to half precision, 0 if the line is unknown; std::nullopt if
// the program has no such step.
std::optional<std::uint32_t> first_half(const Program& program);

// A function of the module that has the name of a kernel of the library.
struct NamedKernel {
  const spirv::Function* function;
  Op op;  // the function of the library that a kernel of this name approximates
};
std::vector<NamedKernel> kernels_of(const spirv::Module& module);

// Removes the steps on which no result depends.
void remove_unused(Program& program);

}  // namespace brdf::shader
