// The functions that a shader's text defines, its declarations, and the text without some of them.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace brdf::shader {

// Of a name or a number.
constexpr bool is_word(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || (c >= '0' && c <= '9');
}

struct Definition {
  std::string name;                             // of a declaration the last one it declares
  std::size_t begin = 0, end = 0;               // in the text: from its type to its last brace
  std::uint32_t first_line = 0, last_line = 0;  // of the text, from 1
  bool is_declaration = false;                  // of a variable, a block or a type
};

// In the text's order; `text` is without comments. Preprocessor lines are passed over as if all of them were
// true.
std::vector<Definition> definitions_of(const std::string& text, bool declarations = false);

// The text with blanks in place of these; lines stay where they are.
std::string without(std::string text, std::span<const Definition> left_out);

}  // namespace brdf::shader
