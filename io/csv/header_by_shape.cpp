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

// Returns the fields of a line that looks like a row of the table; otherwise an empty list.
Fields fields_of_row(std::string_view line, Dialect& dialect) {
  Fields fields;
  if (!dialect.split_header(line, fields)) return {};
  const auto numbers =
      std::ranges::count_if(fields, [&](std::string_view f) { return is_number_in(dialect, f); });
  return std::size_t(numbers) >= kFewestNumbers && 2 * std::size_t(numbers) >= fields.size() ? fields
                                                                                             : Fields();
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
  Fields row;
  for (std::size_t count = 0; count < kMostLinesAhead; ++count) {
    Dialect dialect = dialect_;
    if (!line.empty() && !line.starts_with(comment_sign())) {
      row = fields_of_row(line, dialect);
      if (!row.empty()) break;
      above.emplace_back(ahead.line(), line);
    }
    if (!ahead.next(line)) break;
    line = trimmed(line);
  }
  if (row.empty()) fail("no header row and no row of numbers are found");
  const auto has_width = [&](std::string_view text, Fields& fields) {
    Dialect dialect = dialect_;
    return dialect.split_header(text, fields) && fields.size() == row.size();
  };
  Fields fields;
  while (!above.empty() && has_width(above.back().second, fields) && above.size() > 1 &&
         std::ranges::all_of(fields, is_unit))
    above.pop_back();  // a row of units
  if (!above.empty() && has_width(above.back().second, fields)) {
    for (std::string_view skipped; reader_.line() < above.back().first;) reader_.next(skipped);
    read_names(above.back().second);
    return false;
  }
  if (above.empty() && has_width(last_comment_, fields)) {
    read_names(last_comment_);
    return true;
  }
  if (!above.empty()) fail("the lines above the numbers do not name " + plural(row.size(), "column"));
  return true;
}

}  // namespace brdf::io
