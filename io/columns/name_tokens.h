// Splits a column's name into words, numbers and signs.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace brdf::io {

struct Token {
  enum class Type { word, number, sign } type;
  std::string text;        // in small letters
  std::size_t begin, end;  // byte offsets in the name
  bool is_used = false;    // set by a reader that has interpreted the token
};

// Returns the tokens of a name. Words are runs of letters and end before a capital that follows a small
// letter: "ReflectanceFactor" is two words. Blanks and underscores are skipped.
std::vector<Token> tokens_of(std::string_view name);

// Returns whether the token is a bracket, a hyphen or a similar sign, which separates words and has no
// meaning.
bool is_silent(const Token& token);

}  // namespace brdf::io
