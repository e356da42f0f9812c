#include "io/columns/comments.h"

#include <utf8.h>

#include <cstdint>
#include <iterator>

#include "io/columns/stated_quantity.h"
#include "io/files/text.h"

namespace brdf::io {
namespace {

// Returns the text as UTF-8 without control characters other than tabs.
std::string on_one_line(const std::string& text) {
  const std::string valid = utf8::replace_invalid(text);
  std::string line;
  for (auto at = valid.begin(); at != valid.end();) {
    const std::uint32_t c = utf8::next(at, valid.end());
    const bool is_control = (c < 0x20 && c != '\t') || (c >= 0x7f && c < 0xa0);
    utf8::append(is_control ? U' ' : static_cast<char32_t>(c), std::back_inserter(line));
  }
  return line;
}

}  // namespace

Comment parse_comment(std::string_view text) {
  const std::string line = on_one_line(std::string(text));
  const std::string_view view = line;
  const std::size_t colon = view.find(':');
  if (colon == view.npos) return {"", std::string(trimmed(view))};
  return {std::string(trimmed(view.substr(0, colon))), std::string(trimmed(view.substr(colon + 1)))};
}

std::string comment_text(const Comment& comment) {
  const std::string key(trimmed(on_one_line(comment.first)));
  const std::string text = on_one_line(key.empty() ? comment.second : key + ": " + comment.second);
  const bool would_have_key = key.empty() && text.find(':') != text.npos;
  return (would_have_key || quantity_in_comment(text) ? ": " : "") + text;
}

}  // namespace brdf::io
