// How a shader's value depends on its parameters: facts that the flattened program shows for all directions
// and all parameters, without evaluating it.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "shader/function.h"

namespace brdf::shader {

// The components of colours on which channel k of the value may depend, by data or by a branch.
enum class Mixing {
  none,   // component k alone
  first,  // component k and the first one
  all     // any; or the program is too large to be followed
};
Mixing mixing_of(const Function& function);

// Returns true if equal components of all colours give equal components of the value, because the same
// operations compute them. If false, nothing is known.
bool same_in_all_channels(const Function& function);

// How the value depends on the parameters, by their index; in exact arithmetic. A parameter is followed only
// if it is among the first 64.
struct Degrees {
  // The value is a straight line in the parameter within the parameter's range, except perhaps at the two
  // ends of the range, at which a comparison such as `weight > 0` may decide otherwise.
  bool is_affine(std::size_t parameter) const;
  // No term contains both parameters; both are affine.
  bool is_separate(std::size_t a, std::size_t b) const;

  std::uint64_t nonlinear = ~std::uint64_t(0);  // parameters, as bits
  std::vector<std::uint64_t> joint = {};        // for each parameter those with which a product contains it
};
Degrees degrees_of(const Function& function);

// Returns true if the value is 0 wherever these parameters are 0, whatever the others are. If false,
// nothing is known.
bool vanishes_with(const Function& function, const std::vector<std::size_t>& parameters);

}  // namespace brdf::shader
