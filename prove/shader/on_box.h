// A user's shader on a box of its parameters and directions: every value that its interpreter can compute
// there.
//
// Numbers are intervals, integers and truths ranges. Where a branch is open both ways are followed, each with
// what the comparison says of the numbers that it compared; what is returned is the hull of all ways. A
// vector divided by its own length has coordinates from -1 to 1 if the sum of their squares is no subnormal
// number: sums of squares are followed to the division. Where an operand may make an operation undefined by
// the language its result is poison, and so is all that depends on it.
#pragma once

#include <array>
#include <optional>
#include <string>

#include "prove/scalar/interval.h"
#include "shader/function.h"
#include "shader/undefined.h"

namespace brdf::prove {

// Names an operation that is not known on intervals; nothing where all are.
std::string unknown_operation(const shader::Program& program);

struct ShaderInputs {
  std::vector<Bounds> values;  // of the function's parameters, in its order
  Bounds cos_i, turn_i, cos_o, turn_o;
};

// f_r of all components of the function's value, 1/sr. lo = -inf where it may be no number, infinite or
// undefined, or where the program has too many ways.
struct ShaderBounds {
  Bounds value;
  // An undefined value that the result may depend on in the box, with its line.
  std::optional<shader::UndefinedValue> undefined = {};
};

// For the light at turn_i; where that is one turn and the function's symmetry is shown, for the light at
// every turn.
template <class B>
ShaderBounds shader_on_box(const shader::Function& function, const ShaderInputs& inputs);

}  // namespace brdf::prove
