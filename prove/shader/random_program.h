// Random shaders: sound ones, and shaders with a planted violation that few samples would meet.
#pragma once

#include <random>
#include <string>

#include "prove/check/claim.h"

namespace brdf::prove {

// The kind of violation that is planted into a shader.
enum class Planted { nothing, negative, infinite, undefined };

struct RandomProgram {
  std::string text;  // GLSL
  Planted planted = Planted::nothing;
  // The place of the violation: "slab", "ball", "line", "azimuth", "subnormal", "overflow", or the undefined
  // operation and its place.
  std::string where;
  // The fault shows only in float, because it is a fault of rounding.
  bool float_only = false;
};

// Returns a function that is finite, at least 0 and defined for all values of its parameters and for light
// and viewers above the horizon: sums, products, quotients, roots, powers, branches, loops and arrays of
// numbers between 0 and about 10.
RandomProgram sound_program(std::mt19937_64& random);
// Returns a function with one violation: in a slab, a ball, a line or a range of azimuths with a width
// between 1e-7 and 1e-2, in the subnormal range, by an overflow at some turns of the light, or by one of the
// operations that GLSL leaves undefined.
RandomProgram planted_program(std::mt19937_64& random);

// Returns whether a proof of this property would be false for the program.
bool contradicts(const RandomProgram& program, Property property, Precision precision);

}  // namespace brdf::prove
