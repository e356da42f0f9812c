// What fills a shader's inputs before a run: directions and parameters, told by names and by what the file
// says.
#pragma once

#include <set>
#include <utility>

#include "shader/function.h"

namespace brdf::shader {

// Slots of a program (integers: true) that some step reads before the end.
std::set<std::pair<bool, std::uint32_t>> read_slots(const Program& program);

// Makes the function's parameters and the bindings of its two programs. Throws InputError where the file or
// the command line speaks of parameters that are not there, or leaves open what must be said.
void bind_inputs(Function& function);

}  // namespace brdf::shader
