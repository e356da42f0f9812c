// Lines, fields and numbers of text, and text that is safe to print.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/files/content.h"

namespace brdf::io {

// Returns the lines of a text one by one. Lines end in LF or CRLF; a byte order mark is skipped. Throws
// InputError for a line longer than kLongestLine.
class LineReader {
 public:
  // The content must outlive the reader.
  explicit LineReader(const Content& content) : content_(&content), rest_(content.bytes) {}
  explicit LineReader(Content&&) = delete;
  // Reads the next line. Returns false at the end of the text.
  bool next(std::string_view& line);
  std::size_t line() const { return line_; }  // of the last line returned, from 1
  const Content& content() const { return *content_; }
  // Returns "FILE, line N".
  std::string where() const;

 private:
  const Content* content_;
  std::string_view rest_;
  std::size_t line_ = 0;
};

// Converts the capitals A to Z to small letters; other characters stay unchanged.
std::string lower_case(std::string_view text);

// Removes blanks and tabs at both ends.
std::string_view trimmed(std::string_view text);

// Splits at `separator`. Fields are trimmed; empty fields are kept.
void split(std::string_view line, char separator, std::vector<std::string_view>& fields);
// Splits at runs of blanks and tabs.
void split_blanks(std::string_view line, std::vector<std::string_view>& fields);

// Parses the whole of `text` as a number; a leading plus sign is allowed. Returns false if the text is not
// a number or is out of the range of double.
bool parse_number(std::string_view text, double& value);

// Returns text that is safe to show to people. Control characters are written as \x1b, and characters that
// change the direction of text as \u202e, so that a file or its name cannot control a terminal or disguise
// another text. The text is cut after `most` bytes.
std::string printable(std::string_view text, std::size_t most = std::string_view::npos);
// Escapes, in JSON text, the characters that printable() escapes and that JSON allows unescaped, as \u202e.
std::string with_escaped_marks(std::string json);
// Returns text from a file in single quotes for messages: the first 60 bytes as printable() shows them.
std::string shown(std::string_view text);

// Returns the text in double quotes as a field of CSV; quotes inside are doubled.
std::string csv_quoted(std::string_view text);

// Writes the shortest decimal that reads back to the same double.
void append_number(std::string& out, double value);
std::string to_text(double value);

}  // namespace brdf::io
