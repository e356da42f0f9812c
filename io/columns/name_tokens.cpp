#include "io/columns/name_tokens.h"

#include <charconv>

#include "io/files/text.h"

namespace brdf::io {
namespace {

bool is_digit(char c) {
  return c >= '0' && c <= '9';
}
bool is_capital(char c) {
  return c >= 'A' && c <= 'Z';
}
bool is_word(char c) {
  return is_capital(c) || (c >= 'a' && c <= 'z') || static_cast<unsigned char>(c) >= 0x80 || c == '\'';
}

}  // namespace

std::vector<Token> tokens_of(std::string_view name) {
  std::vector<Token> tokens;
  for (std::size_t k = 0; k < name.size();) {
    const std::size_t begin = k;
    const char c = name[k];
    Token::Type type = Token::Type::sign;
    if (is_digit(c)) {
      type = Token::Type::number;
      double number;
      const auto result = std::from_chars(name.data() + k, name.data() + name.size(), number);
      k = static_cast<std::size_t>(result.ptr - name.data());
      if (k == begin) ++k;
    } else if (is_word(c)) {
      type = Token::Type::word;
      for (++k; k < name.size() && is_word(name[k]); ++k)
        if (is_capital(name[k]) && !is_capital(name[k - 1])) break;
    } else {
      ++k;
      if (c == ' ' || c == '\t' || c == '_') continue;
    }
    tokens.push_back({type, lower_case(name.substr(begin, k - begin)), begin, k});
  }
  return tokens;
}

bool is_silent(const Token& token) {
  constexpr std::string_view kSilent = "-()[]{},.:;\"";
  return token.type == Token::Type::sign && kSilent.find(token.text) != kSilent.npos;
}

}  // namespace brdf::io
