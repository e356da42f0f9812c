// Changes that keep the form of what is changed: words of a text, instructions of a module.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace brdf::fuzz {

// A shader's text with one to four of its words, numbers, operators or statements exchanged, repeated or left out.
std::string mutate_shader(std::string_view text, std::uint32_t seed);
// A SPIR-V module with one to four operands, operations or instructions exchanged, repeated or left out; lengths stay right.
std::string mutate_spirv(std::string_view bytes, std::uint32_t seed);

}  // namespace brdf::fuzz
