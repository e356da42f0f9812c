// Translates GLSL into the keywords of a similar language.
#pragma once

#include <algorithm>
#include <cctype>
#include <string>

namespace brdf::io {

// Replaces every word outside comments by the result of `change`. Numbers, members (f.r) and names of a
// namespace (std::exp) count as words.
template <class Change>
std::string with_words(const std::string& text, Change&& change) {
  const auto in_word = [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '.' || c == ':';
  };
  std::string out;
  for (std::size_t k = 0; k < text.size();) {
    std::size_t end = k;
    if (text.compare(k, 2, "//") == 0) {
      end = std::min(text.find('\n', k), text.size());
      out += text.substr(k, end - k);
    } else if (in_word(text[k])) {
      while (end < text.size() &&
             (in_word(text[end]) || ((text[end] == '-' || text[end] == '+') && text[end - 1] == 'e' &&
                                     std::isdigit(static_cast<unsigned char>(text[k])))))
        ++end;
      out += change(text.substr(k, end - k));
    } else {
      out += text[end++];
    }
    k = end;
  }
  return out;
}

// Replaces every occurrence of `what` by `by`.
inline void replace_all(std::string& text, const std::string& what, const std::string& by) {
  for (std::size_t at = 0; (at = text.find(what, at)) != text.npos; at += by.size())
    text.replace(at, what.size(), by);
}

}  // namespace brdf::io
