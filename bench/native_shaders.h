// The formulas of data/shaders as a programmer would write them in C++, in float: what the interpreter is
// compared with.
#pragma once

#include "brdf/directions.h"

namespace brdf::bench {

// f_r at the parameters' defaults, one channel, for rows of directions above the horizon.
using NativeShader = void (*)(const Directions<float>& d, float* out);
void native_sound(const Directions<float>& d, float* out);
void native_clamped_dot(const Directions<float>& d, float* out);
void native_wrong_norm(const Directions<float>& d, float* out);

}  // namespace brdf::bench
