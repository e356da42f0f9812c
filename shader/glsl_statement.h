// One operation of a flattened program as a statement of GLSL, and the names and literals that it is made of.
#pragma once

#include <cstdint>
#include <string>

#include "shader/program/program.h"

namespace brdf::shader {

// The variable that stands for a slot of the bank of numbers, or of integers.
std::string number_slot(std::uint32_t slot);
std::string integer_slot(std::uint32_t slot);

// Literals; a number that is no finite float is written by its bits.
std::string number_text(double value);
std::string integer_text(std::uint32_t value);

// "n7 = n3 * n4;". An element of an array at a changing place is one case after another.
std::string statement(const Step& s);

}  // namespace brdf::shader
