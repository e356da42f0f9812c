// Reads the lines above the rows of a table of text columns: comments, titles, the quantity, and the header
// row with its units.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/columns/column_names.h"
#include "io/columns/layout.h"
#include "io/columns/stated_angles.h"
#include "io/columns/stated_quantity.h"
#include "io/columns/supplied.h"
#include "io/csv/csv_layout.h"
#include "io/csv/dialect.h"
#include "io/csv/matrix_header.h"
#include "io/files/text.h"
#include "io/samples/samples.h"

namespace brdf::io {

// Most columns of a table: names are interpreted in some microseconds each.
inline constexpr std::size_t kWidestTable = 20'000;

class CsvHeader {
 public:
  // The reader, the dialect and the table must outlive this object. Comments and channels are stored in the
  // table.
  CsvHeader(LineReader& reader, Dialect& dialect, SampleTable& table, bool need_values,
            const Supplied& supplied)
      : reader_(reader),
        dialect_(dialect),
        table_(table),
        need_values_(need_values),
        stated_(stated_by_option(supplied.quantity)),
        layout_(layout_for(reader.content().name, supplied)) {}

  // Returns whether the header row has been read.
  bool is_read() const { return !columns_.columns.empty(); }
  // Returns the characters that open a comment line.
  std::string_view comment_sign() const { return layout_ ? layout_->comment : comment_; }
  // Returns whether a line below the header row is a comment of other programs: it begins with '%', '!' or
  // "//", with which no number begins. A layout states its own sign.
  bool is_other_comment(std::string_view line) const;
  void keep_other_comment(std::string_view line);
  void set_comment_sign(std::string_view sign) { comment_ = sign; }
  // Returns the layout that interprets the columns; empty if the header row is interpreted.
  const std::optional<Layout>& layout() const { return layout_; }
  // Reads a comment line, above or below the header row.
  void read_comment(std::string_view line);
  // Reads the first line that is not a comment: the header row, a title above the header row, or numbers if
  // the header row was the last comment, as numpy writes it. Returns true if the line is a row that is
  // still to be read.
  bool read(std::string_view line);

  // Reads the first line that is not a comment for a proposal of a layout: doubts about columns are
  // collected instead of thrown. If no line has names that are understood, the header row is the last line
  // of names above the numbers. Returns true if the line is a row, because the table has no header row; the
  // columns are then empty.
  bool read_for_proposal(std::string_view line, std::vector<ColumnDoubt>& doubts);
  // Returns the names of the columns as written, without the units of a row of units.
  const std::vector<std::string>& written_names() const { return written_names_; }

  // Returns the quantity that the file or the caller states.
  const std::optional<StatedQuantity>& stated() const { return stated_.result(); }
  const Columns& columns() const { return columns_; }
  // Returns the header of a matrix of two angles; empty if the table is not a matrix.
  const std::optional<MatrixHeader>& matrix() const { return matrix_; }
  // Returns whether the table is in the long format, with a column of wavelengths or polarisations.
  bool is_long() const { return is_long_; }

 private:
  [[noreturn]] void fail(const std::string& what) const;
  bool read_by_layout(std::string_view line);
  bool is_header_by_layout(std::string_view line, std::size_t number) const;
  std::size_t line_of_header(std::string_view line) const;
  void use_layout(std::string_view names, std::string_view row);
  void compare_with_layout(std::string_view words);
  bool read_by_shape(std::string_view line);
  bool is_header_in_comment(std::string_view line) const;
  std::string_view behind_titles(std::string_view line);
  void add_title(std::string_view title);
  bool is_header(std::string_view line, bool has_stated_angle) const;
  bool is_above_words(std::string_view line) const;
  std::string_view behind_sign(std::string_view line, bool has_stated_angle) const;
  void read_names(std::string_view line);
  bool has_unscaled_values() const;
  void refuse_other_angle(std::string_view text) const;
  void check_width(std::size_t columns) const;
  void check_lengths(std::span<const std::string_view> names) const;
  std::string refused_values() const;
  bool has_numbers_only(const std::vector<std::string_view>& fields, std::size_t first) const;
  void check_names(const std::vector<std::string_view>& fields) const;
  [[noreturn]] void refuse_numbers(const std::vector<std::string_view>& fields, std::size_t k) const;
  void describe_road_table();
  bool read_matrix(const std::vector<std::string_view>& names);
  void look_ahead(std::vector<std::string>& names, HeaderFacts& facts);
  void check_columns() const;
  bool is_a_title() const;

  LineReader& reader_;
  Dialect& dialect_;
  SampleTable& table_;
  bool need_values_;
  StatedQuantities stated_;
  StatedAngles stated_angles_;
  Columns columns_;
  std::optional<MatrixHeader> matrix_;
  std::string last_comment_;  // the last comment above the header row
  std::size_t last_comment_line_ = 0;
  std::optional<Layout> layout_;
  std::string comment_ = "#";
  std::vector<ColumnDoubt>* doubts_ = nullptr;
  std::vector<std::string> written_names_;
  bool is_long_ = false;
};

}  // namespace brdf::io
