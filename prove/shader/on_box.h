// A user's shader on a box of its parameters and directions: every value that its interpreter can compute
// there.
//
// Numbers are intervals; integers and truths are ranges. If a branch is open, both ways are followed, each
// with the facts that the comparison implies for the compared numbers. The result is the hull of all ways.
// A vector divided by its own length has coordinates from -1 to 1 if the sum of their squares is not
// subnormal: sums of squares are followed to the division. If an operand may make an operation undefined by
// the language, the result of the operation is poison, and so are all results that depend on it.
#pragma once

#include <optional>
#include <string>

#include "prove/scalar/interval.h"
#include "shader/function.h"
#include "shader/undefined.h"

namespace brdf::prove {

// Returns the name of an operation that is not known on intervals; empty if all are known.
std::string unknown_operation(const shader::Program& program);

struct ShaderInputs {
  std::vector<Bounds> values;  // of the function's parameters, in its order
  Bounds cos_i, turn_i, cos_o, turn_o;
};

// f_r of all components of the function's value, 1/sr. lo = -inf if the value may be NaN, infinite or
// undefined, or if the program has too many ways.
struct ShaderBounds {
  Bounds value;
  // An undefined value on which the result may depend in the box, with its line.
  std::optional<shader::UndefinedValue> undefined = {};
};

// Encloses the function for the light at turn_i. If turn_i is a single turn and the symmetry of the
// function is shown, the bounds hold for the light at every turn.
template <class B>
ShaderBounds shader_on_box(const shader::Function& function, const ShaderInputs& inputs);

}  // namespace brdf::prove
