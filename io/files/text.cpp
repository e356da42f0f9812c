#include "io/files/text.h"

#include <utf8.h>

#include <algorithm>
#include <charconv>

#include "io/files/error.h"

namespace brdf::io {

std::string LineReader::where() const {
  return content_->name + ", line " + std::to_string(line_);
}

bool LineReader::next(std::string_view& line) {
  if (rest_.empty()) return false;
  const std::size_t stop = std::min(rest_.find('\n'), rest_.size());
  line = rest_.substr(0, stop);
  rest_.remove_prefix(std::min(stop + 1, rest_.size()));
  if (line.ends_with('\r')) line.remove_suffix(1);
  if (line_++ == 0 && line.starts_with("\xEF\xBB\xBF")) line.remove_prefix(3);
  if (line.size() > kLongestLine)
    throw InputError(where() + ": is longer than " + std::to_string(kLongestLine >> 20) + " MiB");
  return true;
}

std::string lower_case(std::string_view text) {
  std::string out(text);
  for (char& c : out)
    if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
  return out;
}

std::string_view trimmed(std::string_view text) {
  const auto is_blank = [](char c) { return c == ' ' || c == '\t'; };
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

void split(std::string_view line, char separator, std::vector<std::string_view>& fields) {
  fields.clear();
  for (;;) {
    const std::size_t stop = line.find(separator);
    fields.push_back(trimmed(line.substr(0, stop)));
    if (stop == std::string_view::npos) return;
    line.remove_prefix(stop + 1);
  }
}

void split_blanks(std::string_view line, std::vector<std::string_view>& fields) {
  fields.clear();
  for (line = trimmed(line); !line.empty(); line = trimmed(line)) {
    const std::size_t stop = std::min(line.find_first_of(" \t"), line.size());
    fields.push_back(line.substr(0, stop));
    line.remove_prefix(stop);
  }
}

bool parse_number(std::string_view text, double& value) {
  if (text.starts_with('+')) {
    text.remove_prefix(1);
    if (text.starts_with('-')) return false;
  }
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  return error == std::errc() && stop == end;
}

namespace {

// Returns the number of bytes of a character that changes the direction of text, or ends a line, in a
// terminal; 0 if `text` does not begin with such a character.
std::size_t direction_mark(std::string_view text) {
  if (text.starts_with("\xd8\x9c")) return 2;  // U+061C
  if (text.size() < 3 || text[0] != '\xe2') return 0;
  const auto second = static_cast<unsigned char>(text[1]), third = static_cast<unsigned char>(text[2]);
  const bool is_mark = second == 0x80 && (third == 0x8e || third == 0x8f || (third >= 0xa8 && third <= 0xae));
  const bool is_isolate = second == 0x81 && third >= 0xa6 && third <= 0xa9;
  return is_mark || is_isolate ? 3 : 0;
}

void append_hex(std::string& out, unsigned value, int digits) {
  constexpr std::string_view kHex = "0123456789abcdef";
  for (int k = digits - 1; k >= 0; --k) out += kHex[value >> (4 * k) & 15];
}

}  // namespace

std::string with_escaped_marks(std::string json) {
  if (json.find_first_of("\xc2\xd8\xe2") == json.npos) return json;
  std::string out;
  for (std::size_t k = 0; k < json.size(); ++k) {
    const std::string_view rest = std::string_view(json).substr(k);
    const bool is_c1 = rest.size() > 1 && rest[0] == '\xc2' && static_cast<unsigned char>(rest[1]) < 0xa0;
    const std::size_t size = is_c1 ? 2 : direction_mark(rest);
    if (size > 0)
      append_hex(out += "\\u", utf8::peek_next(rest.begin(), rest.end()), 4);
    else
      out += json[k];
    k += size > 0 ? size - 1 : 0;
  }
  return out;
}

std::string printable(std::string_view text, std::size_t most) {
  const bool is_cut = text.size() > most;
  while (is_cut && most > 0 && (text[most] & 0xc0) == 0x80) --most;  // do not cut within a character
  if (is_cut) text = text.substr(0, most);
  const bool is_utf8 = utf8::is_valid(text.begin(), text.end());
  std::string out;
  const auto at = [&](std::size_t k) { return static_cast<unsigned char>(k < text.size() ? text[k] : 0); };
  for (std::size_t k = 0; k < text.size(); ++k) {
    const unsigned char c = at(k);
    // U+0080 to U+009F are control characters too: the byte C2 and one more byte.
    const bool is_c1 = (c == 0xc2 && at(k + 1) < 0xa0) || (c >= 0x80 && c < 0xa0 && at(k - 1) == 0xc2);
    const std::size_t mark = is_utf8 && c >= 0x80 ? direction_mark(text.substr(k)) : 0;
    if (mark > 0) {
      const auto next = text.begin() + static_cast<std::ptrdiff_t>(k);
      append_hex(out += "\\u", utf8::peek_next(next, text.end()), 4);
      k += mark - 1;
    } else if (c < 0x20 || c == 0x7f || is_c1 || (c >= 0x80 && !is_utf8)) {
      append_hex(out += "\\x", c, 2);
    } else {
      out += text[k];
    }
  }
  return is_cut ? out + "..." : out;
}

std::string shown(std::string_view text) {
  constexpr std::size_t kLongest = 60;
  return "'" + printable(text, kLongest) + "'";
}

std::string csv_quoted(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? "\"\"" : std::string(1, c);
  return out + "\"";
}

void append_number(std::string& out, double value) {
  char digits[32];
  const auto result = std::to_chars(digits, digits + sizeof digits, value);
  out.append(digits, result.ptr);
}

std::string to_text(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

}  // namespace brdf::io
