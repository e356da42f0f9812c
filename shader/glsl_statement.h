// Writes one operation of a flattened program as a GLSL statement, with the names and literals that the
// statement uses.
#pragma once

#include <cstdint>
#include <string>

#include "shader/program/program.h"

namespace brdf::shader {

// Returns the name of the variable for a slot of the bank of numbers, or of the bank of integers.
std::string number_slot(std::uint32_t slot);
std::string integer_slot(std::uint32_t slot);

// Returns a literal. A number that is not finite as a float is written by its bits.
std::string number_text(double value);
std::string integer_text(std::uint32_t value);

// Returns a statement such as "n7 = n3 * n4;". Access to an array with a variable index becomes a chain of
// cases.
std::string statement(const Step& s);

}  // namespace brdf::shader
