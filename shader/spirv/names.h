// The GLSL names of the functions in the set GLSL.std.450.
#pragma once

#include <cstdint>
#include <string>

namespace brdf::shader::spirv {

// Returns "inverse" for 34, and "number 99" for 99, which is not in the set.
std::string function_name(std::uint32_t number);

}  // namespace brdf::shader::spirv
