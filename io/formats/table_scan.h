// The facts about a table of text columns from which a layout is proposed (io/formats/describe_table.h).
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "io/columns/column_names.h"
#include "io/csv/csv_header.h"
#include "io/csv/dialect.h"
#include "io/files/content.h"
#include "io/files/text.h"
#include "io/samples/samples.h"

namespace brdf::io {

// The numbers and words of one column.
struct ColumnFacts {
  std::size_t numbers = 0, words = 0;
  double least = 0, largest = 0;
  std::map<double, std::size_t> times;  // of each of the first kMostDistinct numbers and of fill values
  std::set<std::string> word_list;      // the first kMostWords

  static constexpr std::size_t kMostWords = 8, kMostDistinct = 1000;

  void add(double number);
  void add(std::string_view word);
  double largest_size() const;
  // Returns a predicate, such as "holds the number 3 only".
  std::string in_words() const;
};

// Reads all rows, also of a table that the reader of tables refuses.
class TableScan {
 public:
  // The text is UTF-8 and must outlive the object.
  explicit TableScan(const Content& text);
  TableScan(const TableScan&) = delete;
  TableScan& operator=(const TableScan&) = delete;

  // Looks for another sign than '#' in front of the first line. Call it before `read`.
  void find_comment_sign();
  // Reads the table. Throws InputError for a matrix of two angles, for a table of road lighting, for more
  // columns than a layout has entries, and for a text without columns of numbers.
  void read();
  // Reads the table. Returns the numbers that the columns of values hold in these lines (from 1) at least
  // three times. Throws as `read` does.
  std::vector<double> read_numbers_in(const std::vector<std::uint32_t>& lines);

  const CsvHeader& header() const { return header_; }
  // Returns the meanings of the columns, as far as the header row is understood.
  const Columns& found() const { return header_.columns(); }
  const std::vector<Column>& columns() const { return found().columns; }
  const std::vector<ColumnFacts>& facts() const { return facts_; }
  const Dialect& dialect() const { return dialect_; }
  // Returns the sign of comments if it was found to be another one than '#', or an empty string.
  const std::string& comment_sign() const { return comment_; }
  // Returns whether the first line is a row of numbers; `columns` is empty then.
  bool is_without_header() const { return is_without_header_; }
  bool has_angles() const { return found().has_angle(0) && found().has_angle(2); }
  // Returns a null pointer if there is no such doubt.
  const ColumnDoubt* doubt(std::size_t column, ColumnDoubt::Of of) const;

 private:
  void read_header(std::string_view line);
  void read_row(std::string_view line);

  const Content& text_;
  LineReader reader_;
  SampleTable table_;
  Dialect dialect_;
  std::vector<ColumnDoubt> doubts_;
  CsvHeader header_;
  std::string comment_;
  bool has_header_ = false, is_without_header_ = false;
  std::vector<ColumnFacts> facts_;
  std::set<std::uint32_t> lines_of_fill_;
  std::map<double, std::size_t> fill_;  // times of each number in these lines
};

}  // namespace brdf::io
