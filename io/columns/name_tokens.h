// Words, numbers and signs of a column's name.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace brdf::io {

struct Token {
  enum class Type { word, number, sign } type;
  std::string text;        // in small letters
  std::size_t begin, end;  // of the name
  bool is_used = false;    // for readers: it has been understood
};

// Words are runs of letters, parted before a capital after a small letter: "ReflectanceFactor". Blanks and
// underscores are left out.
std::vector<Token> tokens_of(std::string_view name);

// Whether it is a bracket, a hyphen or the like, which parts words and says nothing.
bool is_silent(const Token& token);

}  // namespace brdf::io
