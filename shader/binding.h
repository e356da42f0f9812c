// Determines how a shader's inputs (directions and parameters) are filled before a run, from their names
// and from the declarations of the file and the command line.
#pragma once

#include <set>
#include <string>
#include <utility>

#include "shader/function.h"

namespace brdf::shader {

// Returns the slots of a program that some step reads before the end, each with true for an integer slot.
std::set<std::pair<bool, std::uint32_t>> read_slots(const Program& program);

// Creates the function's parameters and the bindings of its two programs, and of the program of `in_half`,
// which takes the same inputs, unless it is null. `elsewhere`: parameters that other functions of the file
// have. Throws InputError if the file or the command line declares a parameter that
// does not exist, or if a required declaration is missing or invalid.
void bind_inputs(Function& function, Function* in_half = nullptr,
                 const std::set<std::string>& elsewhere = {});
// The same for a sampler or a density, which has some of the parameters only.
void bind_companion(Function& function);

}  // namespace brdf::shader
