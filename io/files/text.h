#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/files/content.h"

namespace brdf::io {

// The lines of a text, LF or CRLF, a byte order mark left out. Throws InputError for a line beyond
// kLongestLine.
class LineReader {
 public:
  // The content must outlive the reader.
  explicit LineReader(const Content& content) : content_(&content), rest_(content.bytes) {}
  explicit LineReader(Content&&) = delete;
  bool next(std::string_view& line);
  std::size_t line() const { return line_; }  // of the last line returned, from 1
  const Content& content() const { return *content_; }
  // "FILE, line N"
  std::string where() const;

 private:
  const Content* content_;
  std::string_view rest_;
  std::size_t line_ = 0;
};

// Latin capitals made small; other characters stay.
std::string lower_case(std::string_view text);

std::string_view trimmed(std::string_view text);

// Splits at `separator`; fields are trimmed, empty ones kept.
void split(std::string_view line, char separator, std::vector<std::string_view>& fields);
// Splits at runs of blanks and tabs.
void split_blanks(std::string_view line, std::vector<std::string_view>& fields);

// The whole of `text` as a number (a leading plus sign is
// allowed). False where it is none or out of double's range.
bool parse_number(std::string_view text, double& value);

// For whatever is shown to people: control characters as \x1b, characters that turn the direction of text as
// \u202e, so that a file or its name cannot drive a terminal or feign another text; cut after `most` bytes.
std::string printable(std::string_view text, std::size_t most = std::string_view::npos);
// JSON text with the characters that printable() does not show, as far as JSON holds them unescaped, as
// \u202e.
std::string with_escaped_marks(std::string json);
// The same as printable() in quotes, for what a file holds: 'text', the first 60 bytes of it.
std::string shown(std::string_view text);

// Shortest decimal that reads back to the same double.
void append_number(std::string& out, double value);
std::string to_text(double value);

}  // namespace brdf::io
