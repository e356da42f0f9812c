// Finds the functions and declarations in a shader's text, and removes some of them from the text.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace brdf::shader {

// Returns whether the character can be part of a name or a number.
constexpr bool is_word(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || (c >= '0' && c <= '9');
}

struct Definition {
  std::string name;                             // for a declaration, the last name that it declares
  std::size_t begin = 0, end = 0;               // in the text: from the type to the last brace
  std::uint32_t first_line = 0, last_line = 0;  // of the text, starting at 1
  bool is_declaration = false;                  // of a variable, a block or a type
};

// Returns the definitions in the order of the text. `text` must not contain comments. Preprocessor lines
// are skipped, as if every condition were true.
std::vector<Definition> definitions_of(const std::string& text, bool declarations = false);

// Returns the text with blanks in place of these definitions; line numbers do not change.
std::string without(std::string text, std::span<const Definition> left_out);

}  // namespace brdf::shader
