// Random shaders: sound ones, and ones with a planted violation that few samples would meet.
#pragma once

#include <cstdint>
#include <random>
#include <string>

#include "prove/check/claim.h"

namespace brdf::prove {

// What is planted into a shader.
enum class Planted { nothing, negative, infinite, undefined };

struct RandomProgram {
  std::string text;  // GLSL
  Planted planted = Planted::nothing;
  std::string where;  // "slab", "ball", "line", "azimuth", "subnormal" or the undefined operation
  // The fault shows in this precision only, if it is one of rounding.
  bool float_only = false;
};

// A function that is finite, at least 0 and defined for all of its parameters' values and for light and
// viewers above the horizon: sums, products, quotients, roots, powers, branches, loops and arrays of numbers
// between 0 and some 10.
RandomProgram sound_program(std::mt19937_64& random);
// The same with one violation: in a slab, a ball, a line or a range of azimuths of a width between 1e-7 and
// 1e-2, in the subnormal range, or by one of the operations that GLSL leaves undefined.
RandomProgram planted_program(std::mt19937_64& random);

// Whether this verdict on it would be false.
bool contradicts(const RandomProgram& program, Property property, Precision precision);

}  // namespace brdf::prove
