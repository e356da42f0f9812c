// How a table of columns is written down: what separates its fields, which mark its decimals have.
#pragma once

#include <deque>
#include <string>
#include <string_view>
#include <vector>

namespace brdf::io {

// Of a line that split_header or split_row cannot split.
inline constexpr std::string_view kBadQuotation =
    "a quotation mark is not closed in its line, or text follows it";

// Comma, semicolon, tab or blanks between fields, as the header row or a line `sep=;` says; fields may stand
// in double quotes (RFC 4180); numbers have a decimal point, or a decimal comma throughout where that cannot
// be a separator.
class Dialect {
 public:
  // Whether the line is spreadsheets' `sep=;`, which is then obeyed.
  bool is_separator_line(std::string_view line);
  // Splits the header row, a line without blanks at its ends, whose separator this finds: a comma where that
  // gives the four plain names, else the first of tab, semicolon, comma that stands outside quotes and
  // brackets at least twice, or once where blanks part fewer than three names; else blanks. Empty names at
  // its end are left out, as fields under them are. False as in split_row.
  bool split_header(std::string_view line, std::vector<std::string_view>& names);
  // Splits a row; false where a quotation mark is not closed, or text follows a closed one. The fields stay
  // valid until the next line is split.
  bool split_row(std::string_view line, std::vector<std::string_view>& fields);
  // A field as a number. False where it is none, or has the other decimal mark than those before.
  bool parse(std::string_view field, double& value);

  bool separates_by_blanks() const { return separator_ == ' '; }
  // Whether a number of either mark has been read, and one of the other refused since.
  bool marks_are_mixed() const { return is_mixed_; }
  // What separates fields, in words: "','", "a tab".
  std::string separator_in_words() const;
  // What differs from commas between fields and points in numbers, in words; empty where nothing does.
  std::string differences() const;

 private:
  char separator_of(std::string_view line);
  void join_units(std::vector<std::string_view>& names);
  bool split(std::string_view line, std::vector<std::string_view>& fields);
  bool split_quoted(std::string_view line, std::vector<std::string_view>& fields);
  // Adds the field whose quotation mark `line` begins with, and leaves what follows it.
  bool take_quotation(std::string_view& line, std::vector<std::string_view>& fields);
  bool separates(char c) const;
  void skip_blanks(std::string_view& line) const;

  char separator_ = 0;  // ' ': runs of blanks
  bool is_stated_ = false, has_quotes_ = false, is_mixed_ = false;
  char mark_ = 0;                     // of the decimals, once seen
  std::size_t surplus_ = 0;           // empty names at the header's end
  std::deque<std::string> unquoted_;  // and joined names
};

}  // namespace brdf::io
