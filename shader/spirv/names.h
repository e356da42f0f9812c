// What the functions of GLSL's own set are called in GLSL.
#pragma once

#include <cstdint>
#include <string>

namespace brdf::shader::spirv {

// "inverse" of 34; a number that the set does not have is "number 99".
std::string function_name(std::uint32_t number);

}  // namespace brdf::shader::spirv
