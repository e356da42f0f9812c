// The header row of a table for which a layout is proposed: its names need not be understood.
#include <algorithm>

#include "io/csv/csv_header.h"
#include "io/files/numbers.h"

namespace brdf::io {
namespace {

using Fields = std::vector<std::string_view>;

constexpr std::size_t kMostLinesAhead = 60;  // lines above the first row of numbers
constexpr std::size_t kFewestNumbers = 3;    // of a row

bool is_number_in(Dialect& dialect, std::string_view field) {
  double number;
  return dialect.parse(field, number);
}

// Returns the number of fields of a line that looks like a row of the table; 0 for other lines.
std::size_t fields_in_row(std::string_view line, Dialect dialect) {
  Fields fields;
  if (!dialect.split_header(line, fields)) return 0;
  const auto numbers = std::size_t(
      std::ranges::count_if(fields, [&](std::string_view f) { return is_number_in(dialect, f); }));
  return numbers >= kFewestNumbers && 2 * numbers >= fields.size() ? fields.size() : 0;
}

}  // namespace

bool CsvHeader::read_for_proposal(std::string_view line, std::vector<ColumnDoubt>& doubts) {
  doubts_ = &doubts;
  const std::size_t first = reader_.line();
  if (is_header_in_comment(line)) return read(line);
  const std::string_view header = behind_titles(line);
  if (!is_header(header, !stated_angles_.is_empty()) && reader_.line() == first) return read_by_shape(line);
  read_names(header);
  return false;
}

// Takes the last line of names above the numbers as the header row. Returns true if there is no such line.
bool CsvHeader::read_by_shape(std::string_view line) {
  LineReader ahead = reader_;
  std::vector<std::pair<std::size_t, std::string_view>> above;  // lines that are not rows
  std::size_t width = 0;                                        // of a row
  for (std::size_t count = 0; count < kMostLinesAhead; ++count) {
    if (!line.empty() && !line.starts_with(comment_sign())) {
      width = fields_in_row(line, dialect_);
      if (width > 0) break;
      above.emplace_back(ahead.line(), line);
    }
    if (!ahead.next(line)) break;
    line = trimmed(line);
  }
  if (width == 0) fail("no header row and no row of numbers are found");
  Fields fields;
  Dialect dialect;  // holds the text of the fields
  const auto has_width = [&](std::string_view text) {
    dialect = dialect_;
    return dialect.split_header(text, fields) && fields.size() == width;
  };
  while (!above.empty() && has_width(above.back().second) && above.size() > 1 &&
         std::ranges::all_of(fields, is_unit))
    above.pop_back();  // a row of units
  if (!above.empty() && has_width(above.back().second)) {
    for (std::string_view skipped; reader_.line() < above.back().first;) reader_.next(skipped);
    read_names(above.back().second);
    return false;
  }
  if (above.empty() && has_width(last_comment_)) {
    read_names(last_comment_);
    return true;
  }
  if (!above.empty()) fail("the lines above the numbers do not name " + plural(width, "column"));
  return true;
}

}  // namespace brdf::io
