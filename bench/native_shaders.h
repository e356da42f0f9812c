// The formulas of data/shaders as a programmer would write them in C++, in float, for comparison with the
// interpreter.
#pragma once

#include "brdf/directions.h"

namespace brdf::bench {

// Compute f_r at the parameters' defaults, one channel, for rows of directions above the horizon.
using NativeShader = void (*)(const Directions<float>& d, float* out);
void native_sound(const Directions<float>& d, float* out);
void native_clamped_dot(const Directions<float>& d, float* out);
void native_wrong_norm(const Directions<float>& d, float* out);

}  // namespace brdf::bench
