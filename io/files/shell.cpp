#include "io/files/shell.h"

#include <utf8.h>

#include <algorithm>

#include "io/files/standard_input.h"

namespace brdf::io {
namespace {

std::string with_escapes(std::string_view word, bool ascii_only) {
  std::string result = "$'";
  for (const char c : word) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7f || (ascii_only && byte >= 0x80)) {
      result += '\\';
      for (const int shift : {6, 3, 0}) result += char('0' + (byte >> shift & 7));
    } else {
      if (c == '\'' || c == '\\') result += '\\';
      result += c;
    }
  }
  return result + "'";
}

}  // namespace

std::string shell_word(std::string_view word) {
  constexpr std::string_view kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=.,:/@%";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string_view::npos) return std::string(word);
  const auto is_control = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; };
  const bool is_utf8 = utf8::is_valid(word.begin(), word.end());
  if (!is_utf8 || std::ranges::any_of(word, is_control)) return with_escapes(word, !is_utf8);
  std::string result = "'";
  for (const char c : word) result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

std::string shell_file(std::string_view name) {
  if (is_standard_input(name)) return "-";
  return shell_word(name.starts_with('-') ? "./" + std::string(name) : std::string(name));
}

}  // namespace brdf::io
