// In which parameters a shader's value is linear, found out by asking it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "brdf/reflectance.h"
#include "shader/function.h"

namespace brdf::shader {

struct Linear {
  std::vector<std::size_t> weights;  // parameters, in their order
  std::vector<LobeWeight> lobes;     // by place in `weights`
  int f0 = -1;                       // place in `weights` of the one that divides the lobes of another
};

// Nothing where the value is not linear in anything, or in not all colours. f = sum over lobes of weight
// times lobe to 1e-9 at many directions and parameters chosen at random, without those where the function has
// no value.
std::optional<Linear> linear_parameters(const Function& function);

// What is said of a function that has no finite value at some of the places at which it is asked; empty: it
// has one at all. Each of them is within the parameters' ranges.
std::string said_of_holes(const Function& function);

// Whether it is 0 at all of many places chosen at random.
bool is_zero_where_asked(const Function& function);

// Whether a channel's value depends on its own component of every colour only.
bool keeps_channels(const Function& function);

// Whether the value is not reciprocal as it is, and is where the cosine to the light is taken out: then it
// holds that cosine.
bool holds_cosine(const Function& function);

// Whether equal components of all colours give equal components of the value.
bool same_in_all_channels(const Function& function);

}  // namespace brdf::shader
