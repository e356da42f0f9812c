// A user's shader on a box of its parameters and directions: every value that its interpreter can compute there.
//
// Numbers are intervals; integers and truths are known or open. Where a branch is open both ways are followed, each with what the
// comparison says of the numbers that it compared; what is returned is the hull of all ways. A vector divided by its own length has
// coordinates from -1 to 1: sums of squares are followed to the division.
#pragma once

#include <array>
#include <string>

#include "prove/scalar/interval.h"
#include "shader/function.h"

namespace brdf::prove {

// Names an operation that is not known on intervals; nothing where all are.
std::string unknown_operation(const shader::Program& program);

struct ShaderInputs {
  std::vector<Bounds> values;  // of the function's parameters, in its order
  Bounds cos_i, turn_i, cos_o, turn_o;
};

// f_r of all components of what is returned; lo = -inf where it may be no number or infinite, or where the program has too many ways.
template <class B>
Bounds shader_on_box(const shader::Function& function, const ShaderInputs& inputs);

}  // namespace brdf::prove
