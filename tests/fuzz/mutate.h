// Changes of inputs. Changes of a text's words and of a module's instructions keep the form of the input.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace brdf::fuzz {

// Returns whether the bytes hold no control characters except white space.
bool is_text(std::string_view bytes);
// Returns the text with one to four of its words, numbers, signs or statements exchanged, repeated or
// removed.
std::string mutate_text(std::string_view text, std::uint32_t seed);
// Returns the bytes with one to four changes: single bytes changed, or runs of bytes exchanged, repeated or
// removed.
std::string mutate_bytes(std::string_view bytes, std::uint32_t seed);
// Returns a SPIR-V module with one to four operands, operations or instructions exchanged, repeated or
// removed. The lengths of instructions remain right.
std::string mutate_spirv(std::string_view bytes, std::uint32_t seed);

}  // namespace brdf::fuzz
