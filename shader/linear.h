// Finds the parameters in which a shader's value is linear, from its program and by evaluating it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "brdf/reflectance.h"
#include "shader/function.h"

namespace brdf::shader {

struct Linear {
  std::vector<std::size_t> weights;  // parameters, in their order
  std::vector<LobeWeight> lobes;     // by position in `weights`
  // Position in `weights` of the f0 that divides another weight's lobes; -1: no f0.
  int f0 = -1;
};

// Returns the parameters in which the value is linear; std::nullopt if there are no such parameters, or if
// a colour is not among them. The program shows that f is the sum of weight times lobe between the ends of
// the weights' ranges (shader/dependence.h). That the ends are no exception, f is evaluated at many
// directions and parameters chosen at random, to 1e-9, except places where the function has no value.
std::optional<Linear> linear_parameters(const Function& function);

// Returns a note on a function that has no finite value at some of the tested places, all of which are
// within the parameters' ranges; empty if all values are finite.
std::string said_of_holes(const Function& function);

// Returns whether the function is 0 at all of many places chosen at random.
bool is_zero_where_asked(const Function& function);

// Returns whether the value is not reciprocal, but becomes reciprocal when divided by the cosine to the
// light. In this case the value contains that cosine.
bool holds_cosine(const Function& function);

}  // namespace brdf::shader
