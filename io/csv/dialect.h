// The notation of a table of columns: the separator of its fields and the decimal mark of its numbers.
#pragma once

#include <deque>
#include <string>
#include <string_view>
#include <vector>

namespace brdf::io {

// The message for a line that split_header() or split_row() cannot split.
inline constexpr std::string_view kBadQuotation =
    "a quotation mark is not closed in its line, or text follows it";

// Fields are separated by commas, semicolons, tabs or blanks, according to the header row or a line
// `sep=;`. Fields may be in double quotes (RFC 4180). Numbers have a decimal point, or throughout a decimal
// comma if the comma cannot be a separator.
class Dialect {
 public:
  // Returns whether the line is `sep=;` as spreadsheets write it. If so, takes the separator from the line.
  bool is_separator_line(std::string_view line);
  // Splits the header row, which must have no blanks at its ends, and determines the separator:
  // - a comma, if that gives the four plain names;
  // - otherwise the first of tab, semicolon and comma that occurs at least twice outside quotes and
  //   brackets, or once if blanks separate fewer than three names;
  // - otherwise blanks.
  // Empty names at the end are removed, and so are empty fields below them. Returns false under the
  // conditions of split_row().
  bool split_header(std::string_view line, std::vector<std::string_view>& names);
  // Splits a row. Returns false if a quotation mark is not closed or if text follows a closed one. The
  // fields stay valid until the next line is split.
  bool split_row(std::string_view line, std::vector<std::string_view>& fields);
  // Parses a field as a number. Returns false if the field is not a number, or if its decimal mark differs
  // from that of the numbers before.
  bool parse(std::string_view field, double& value);

  // Sets the separator, or the decimal mark, instead of finding it. ' ' separates at runs of blanks.
  void state_separator(char separator);
  void state_mark(char mark) { mark_ = mark; }

  // The separator; ' ': runs of blanks. The decimal mark, or 0 if no number had one.
  char separator() const { return separator_; }
  char mark() const { return mark_; }
  bool separates_by_blanks() const { return separator_ == ' '; }
  // Returns whether the last number with a decimal mark was refused because the mark differs from the one
  // before.
  bool marks_are_mixed() const { return is_mixed_; }
  // Returns the separator in words: "','", "a tab".
  std::string separator_in_words() const;
  // Returns the differences from commas between fields and points in numbers, in words; empty if there are
  // no differences.
  std::string differences() const;

 private:
  char separator_of(std::string_view line);
  void join_units(std::vector<std::string_view>& names);
  bool split(std::string_view line, std::vector<std::string_view>& fields);
  bool split_quoted(std::string_view line, std::vector<std::string_view>& fields);
  // Adds the quoted field at the beginning of `line` and removes the field from `line`.
  bool take_quotation(std::string_view& line, std::vector<std::string_view>& fields);
  bool separates(char c) const;
  void skip_blanks(std::string_view& line) const;

  char separator_ = 0;  // ' ': runs of blanks
  bool is_stated_ = false, has_quotes_ = false, is_mixed_ = false;
  char mark_ = 0;                     // decimal mark; 0 until one has been read
  std::size_t surplus_ = 0;           // empty names at the end of the header row
  std::deque<std::string> unquoted_;  // memory of unquoted and joined names
};

}  // namespace brdf::io
