// Changes of inputs; those of a text's words and of a module's instructions keep the form of what is changed.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace brdf::fuzz {

// Whether it holds no control characters but blanks.
bool is_text(std::string_view bytes);
// A text with one to four of its words, numbers, signs or statements exchanged, repeated or left out.
std::string mutate_text(std::string_view text, std::uint32_t seed);
// One to four of the bytes changed, or runs of them exchanged, repeated or left out.
std::string mutate_bytes(std::string_view bytes, std::uint32_t seed);
// A SPIR-V module with one to four operands, operations or instructions exchanged, repeated or left out;
// lengths stay right.
std::string mutate_spirv(std::string_view bytes, std::uint32_t seed);

}  // namespace brdf::fuzz
