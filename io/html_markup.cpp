#include "io/html_markup.h"

#include <array>
#include <cstdint>

namespace brdf::io {
namespace {

std::string base64(std::string_view bytes) {
  constexpr std::string_view kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t k = 0; k < bytes.size(); k += 3) {
    std::uint32_t group = 0;
    for (std::size_t j = 0; j < 3; ++j)
      group = group << 8 | (k + j < bytes.size() ? static_cast<unsigned char>(bytes[k + j]) : 0u);
    for (std::size_t j = 0; j < 4; ++j)
      text += k + j <= bytes.size() && (j < 2 || k + j - 1 < bytes.size())
                  ? kDigits[group >> (18 - 6 * j) & 63]
                  : '=';
  }
  return text;
}

}  // namespace

std::string html_escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == '<')
      out += "&lt;";
    else if (c == '>')
      out += "&gt;";
    else if (c == '&')
      out += "&amp;";
    else if (c == '"')
      out += "&quot;";
    else
      out += c;
  }
  return out;
}

std::string file_name(std::string_view path) {
  const std::size_t slash = path.find_last_of('/');
  return std::string(slash == path.npos || slash + 1 == path.size() ? path : path.substr(slash + 1));
}

const char* css_class(Mark mark) {
  constexpr std::array names{"", "good", "warn", "bad", "absent"};
  return names[std::size_t(mark)];
}

std::string class_of(Mark mark) {
  return mark == Mark::none ? "" : std::string(" class=\"") + css_class(mark) + "\"";
}

std::string after_space(std::string_view word) {
  return word.empty() ? "" : " " + std::string(word);
}

std::string linked(std::string_view address, const std::string& html) {
  return address.empty() ? html : "<a href=\"" + html_escaped(address) + "\">" + html + "</a>";
}

std::string image(std::string_view png, std::string_view alt) {
  return "<img alt=\"" + html_escaped(alt) + "\" src=\"data:image/png;base64," + base64(png) + "\">";
}

}  // namespace brdf::io
