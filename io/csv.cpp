#include "io/csv.h"

#include <algorithm>
#include <cmath>
#include <ostream>
#include <unordered_set>

#include "io/channel_colours.h"
#include "io/column_names.h"
#include "io/dialect.h"
#include "io/error.h"
#include "io/long_format.h"
#include "io/no_number.h"
#include "io/output.h"
#include "io/table_rules.h"
#include "io/text.h"

namespace brdf::io {
namespace {

constexpr const char* kBadQuotation = "a quotation mark is not closed in its line, or text follows it";

enum class ColumnQuantity { brdf, brdf_cos_i, brdf_cos_o };

class CsvReader {
 public:
  CsvReader(const Content& text, bool need_values) : reader_(text), need_values_(need_values) {
    table_.source = text.name;
  }

  SampleTable read() {
    std::string_view line;
    while (reader_.next(line)) {
      line = trimmed(line);
      if (line.empty()) continue;
      if (line.front() == '#')
        read_comment(line);
      else if (columns().empty() && dialect_.is_separator_line(line))
        continue;
      else if (columns().empty() && !is_header_in_comment(line))
        read_header(line);
      else
        read_row(line);
    }
    if (columns().empty())
      throw InputError(table_.source + ": no header row (theta_i,phi_i,theta_o,phi_o,<channel>...)");
    if (table_.rows() == 0) throw InputError(table_.source + ": holds no rows");
    if (table_.skipped > 0)
      table_.warnings.push_back(std::to_string(table_.skipped) +
                                " rows left out: f_r is undefined where the quantity's cosine is 0");
    note_dialect();
    store_raw_angles();
    return is_long_ ? widened(table_, bands_) : std::move(table_);
  }

 private:
  const std::vector<Column>& columns() const { return header_.columns; }

  [[noreturn]] void fail(const std::string& what) const { throw InputError(reader_.where() + ": " + what); }
  [[noreturn]] void fail(std::size_t column, std::string_view text, const std::string& rule) const {
    fail("column " + std::to_string(column + 1) + " (" + columns()[column].name + "): " + shown(text) + " " +
         rule);
  }

  void read_comment(std::string_view line) {
    if (columns().empty()) last_comment_ = trimmed(line.substr(1));
    Comment comment = parse_comment(line.substr(1));
    if (comment.first == kQuantityKey)
      read_quantity(comment.second);  // and no comment: the table holds f_r whatever the file held
    else
      table_.metadata.push_back(std::move(comment));
  }

  // Where numbers begin without a header row it may be the comment above them, as numpy writes it: that is then read.
  bool is_header_in_comment(std::string_view line) {
    Dialect of_numbers, of_names;
    std::vector<std::string_view> fields;
    double number;
    if (!of_numbers.split_header(line, fields) || fields.empty() || !of_numbers.parse(fields[0], number) ||
        !of_names.split_header(last_comment_, fields) || !has_plain_angle_names(fields))
      return false;
    table_.metadata.pop_back();
    read_header(last_comment_);
    header_.notes.push_back("the header row is the comment above the numbers");
    return true;
  }

  void read_quantity(const std::string& value) {
    if (!columns().empty()) fail("the quantity must be stated before the header row");
    std::string name;
    std::copy_if(value.begin(), value.end(), std::back_inserter(name), [](char c) { return c != ' '; });
    if (name == "f_r*cos_i")
      quantity_ = ColumnQuantity::brdf_cos_i;
    else if (name == "f_r*cos_o")
      quantity_ = ColumnQuantity::brdf_cos_o;
    else if (name != "f_r")
      fail("quantity " + shown(value) + " is unknown (known: f_r, f_r*cos_i, f_r*cos_o)");
  }

  void read_header(std::string_view line) {
    if (!dialect_.split_header(line, fields_)) fail(kBadQuotation);
    double number;
    const bool has_names = std::any_of(fields_.begin(), fields_.end(),
                                       [&](std::string_view name) { return !dialect_.parse(name, number); });
    std::unordered_set<std::string_view> seen;
    for (std::size_t k = 0; k < fields_.size(); ++k) {
      const std::string at = "column " + std::to_string(k + 1);
      if (fields_[k].empty()) fail(at + " has no name; leave out a column of row numbers");
      const bool is_band = has_names && with_band_unit(fields_[k]) != fields_[k];
      if (!is_band && dialect_.parse(fields_[k], number))
        fail("the header row is missing: " + at + " is the number " + shown(fields_[k]) +
             ", not a name; write one above the numbers: theta_i,phi_i,theta_o,phi_o,<channel>...");
      if (!seen.insert(fields_[k]).second)
        fail(
            "column " + shown(fields_[k]) +
            " twice; a reading that was repeated is a row of its own, another channel has a name of its own");
    }
    understand(fields_);
  }

  void understand(const std::vector<std::string_view>& names) {
    header_ = understand_columns(names, reader_.where());
    is_long_ = header_.has(Column::Kind::wavelength) || header_.has(Column::Kind::polarisation);
    check_header();
    table_.channels = header_.channels;
    check_channel_names(table_.channels, reader_.where());
    table_.values.resize(table_.channels.size());
    table_.sigma.resize(table_.channels.size());
    row_values_.resize(table_.channels.size());
    row_sigma_.resize(table_.channels.size());
  }

  // Whether the header row is words between blanks, none of them an angle's.
  bool is_a_title() const {
    return dialect_.separates_by_blanks() &&
           std::none_of(columns().begin(), columns().end(),
                        [](const Column& c) { return c.kind == Column::Kind::angle; });
  }

  void check_header() {
    std::string found;
    for (const Column& c : columns()) found += (found.empty() ? "" : ", ") + shown(c.name);
    for (std::size_t angle = 0; angle < 4; ++angle) {
      const bool is_replaced = angle % 2 == 1 && header_.only_azimuth;
      if (!header_.has_angle(angle) && !is_replaced)
        fail("column '" + std::string(kAngleNames[angle]) +
             "' is missing (theta_i,phi_i,theta_o,phi_o,<channel>...); found, separated by " +
             dialect_.separator_in_words() + ": " + found +
             (is_a_title() ? "; lines above the header row begin with '#'" : ""));
    }
    if (need_values_ && header_.channels.empty()) fail("no value column beside the four angles");
    if (is_long_ && need_values_ && header_.channels.size() != 1)
      fail("a column of " +
           std::string(header_.has(Column::Kind::wavelength) ? "wavelengths" : "polarisations") +
           " needs one column of values, not " + std::to_string(header_.channels.size()));
    for (const auto kind : {Column::Kind::wavelength, Column::Kind::polarisation})
      if (std::count_if(columns().begin(), columns().end(), [&](const Column& c) { return c.kind == kind; }) >
          1)
        fail("two columns of " +
             std::string(kind == Column::Kind::wavelength ? "wavelengths" : "polarisations"));
    for (const Column& c : columns()) has_sigma_ = has_sigma_ || c.kind == Column::Kind::sigma;
  }

  // What differs from the plain format is announced.
  void note_dialect() {
    std::vector<std::string> notes = header_.notes;
    if (const std::string differences = dialect_.differences(); !differences.empty())
      notes.insert(notes.begin(), differences);
    table_.warnings.insert(table_.warnings.begin(), notes.begin(), notes.end());
  }

  void store_raw_angles() {
    for (const Column& c : columns()) {
      if (c.kind != Column::Kind::angle) continue;
      RawAngle& angle = table_.raw_angles[c.index];
      angle.name = c.name;
      angle.has_unit = c.has_unit;
      std::move(raw_[c.index]).store(angle);
    }
  }

  void split_row(std::string_view line) {
    if (!dialect_.split_row(line, fields_)) fail(kBadQuotation);
  }

  // Where the line is one of another separator.
  std::string other_separator(std::string_view line) const {
    for (const auto& [c, words] : {std::pair(',', "','"), std::pair(';', "';'"), std::pair('\t', "a tab")})
      if (words != dialect_.separator_in_words() && fields_.size() == 1 &&
          static_cast<std::size_t>(std::count(line.begin(), line.end(), c)) == columns().size() - 1)
        return std::string("; this line is separated by ") + words;
    return "";
  }

  void read_row(std::string_view line) {
    split_row(line);
    if (table_.rows() == 0 && table_.skipped == 0 && !has_units_ && is_row_of_units()) return;
    if (fields_.size() != columns().size())
      fail(std::to_string(fields_.size()) + " columns where the header has " +
           std::to_string(columns().size()) + ", separated by " + dialect_.separator_in_words() +
           other_separator(line));
    for (std::size_t k = 0; k < columns().size(); ++k) {
      if (columns()[k].kind == Column::Kind::polarisation) {
        read_polarisation(k);
        continue;
      }
      double number;
      if (!dialect_.parse(fields_[k], number))
        fail(k, fields_[k],
             dialect_.marks_are_mixed() ? "has another decimal mark than the numbers before"
                                        : "is not a number" + advice_on(fields_[k]));
      if (columns()[k].kind == Column::Kind::angle) raw_[columns()[k].index].add(number);
      number = columns()[k].converted(number);
      if (!std::isfinite(number)) fail(k, fields_[k], "is not finite" + advice_on(fields_[k]));
      read_number(k, number);
    }
    store_row();
  }

  // Names and units may stand in two rows: as one they are "theta_i (deg)".
  bool is_row_of_units() {
    if (fields_.size() != columns().size() ||
        std::none_of(fields_.begin(), fields_.end(), [](std::string_view f) { return !f.empty(); }))
      return false;
    std::vector<std::string> names;
    for (std::size_t k = 0; k < columns().size(); ++k) {
      const std::string_view unit = fields_[k];
      double number;
      if (dialect_.parse(unit, number) || !is_unit(unit)) return false;
      const bool has_brackets = !unit.empty() && (unit.front() == '[' || unit.front() == '(');
      const std::string in_brackets = has_brackets ? std::string(unit) : "(" + std::string(unit) + ")";
      names.push_back(columns()[k].name + (unit.empty() || unit == "-" ? "" : " " + in_brackets));
    }
    has_units_ = true;
    understand({names.begin(), names.end()});
    return true;
  }

  void read_number(std::size_t k, double number) {
    const Column& column = columns()[k];
    switch (column.kind) {
      case Column::Kind::angle:
        largest_[column.index] = std::max(largest_[column.index], std::abs(number));
        if (column.index % 2 == 0 && std::abs(number) > 90.0) below_horizon(k);
        angles_[column.index] = number;
        break;
      case Column::Kind::value:
        row_values_[column.index] = number;
        break;
      case Column::Kind::sigma:
        if (!(number > 0.0)) fail(k, fields_[k], "must be above 0");
        row_sigma_[column.index] = number;
        break;
      case Column::Kind::wavelength:
        if (!(number > 0.0)) fail(k, fields_[k], "must be above 0");
        band_.nm = number;
        break;
      case Column::Kind::polarisation:
        break;
    }
  }

  void read_polarisation(std::size_t k) {
    band_.polarisation = polarisation_named(fields_[k]);
    if (!band_.polarisation) fail(k, fields_[k], "is no polarisation (s, p, ss, sp, ps, pp, te, tm)");
  }

  // Azimuths in the polar angle's column are told apart from a wrong angle: there are many of them, and the
  // other column never exceeds 90 degrees. Reads the rest of the file for that.
  [[noreturn]] void below_horizon(std::size_t column) {
    const std::size_t theta = columns()[column].index, phi = theta + 1;
    const std::string at = reader_.where() + ": column " + std::to_string(column + 1) + " (" +
                           columns()[column].name + "): " + shown(fields_[column]) + " ";
    std::size_t rows = table_.rows(), above = 0;
    bool first = true;
    for (std::string_view line; first || reader_.next(line); first = false) {
      if (!first) split_row(trimmed(line));
      if (fields_.size() != columns().size()) continue;
      for (std::size_t k = 0; k < columns().size(); ++k) {
        const Column& c = columns()[k];
        double x;
        if (c.kind != Column::Kind::angle || !dialect_.parse(fields_[k], x)) continue;
        x = std::abs(c.converted(x));
        largest_[c.index] = std::max(largest_[c.index], x);
        above += c.index == theta && x > 90.0;
      }
      ++rows;
    }
    if (largest_[phi] <= 90.0 && above > 1 && 4 * above >= rows) {
      const std::string t(kAngleNames[theta]), p(kAngleNames[phi]);
      throw ExchangedColumns(at + "is below the horizon; " + t + " reaches " + to_text(largest_[theta]) +
                             " degrees and " + p + " only " + to_text(largest_[phi]) + ": the columns " + t +
                             " and " + p + " look exchanged");
    }
    throw InputError(at + "is below the horizon (theta must be between -90 and 90 degrees)");
  }

  double divided(double value, double cosine) const {
    if (!std::isfinite(value / cosine))
      fail(to_text(value) + " divided by the cosine " + to_text(cosine) + " is beyond the range of numbers");
    return value / cosine;
  }

  void store_row() {
    // Instruments that swing through the normal write the far side as negative theta.
    for (const int k : {0, 2}) {
      if (angles_[k] < 0.0) {
        angles_[k] = -angles_[k];
        angles_[k + 1] += 180.0;
      }
    }
    if (quantity_ != ColumnQuantity::brdf) {
      const double cosine = cos_degrees(quantity_ == ColumnQuantity::brdf_cos_i ? angles_[0] : angles_[2]);
      if (cosine <= 0.0) {
        ++table_.skipped;
        return;
      }
      for (double& value : row_values_) value = divided(value, cosine);
      for (double& sigma : row_sigma_) sigma = divided(sigma, cosine);
    }
    if (table_.rows() == kMostRows) fail("more than " + std::to_string(kMostRows) + " rows");
    table_.add_directions(angles_[0], angles_[1], angles_[2], angles_[3]);
    for (std::size_t c = 0; c < row_values_.size(); ++c) table_.values[c].push_back(row_values_[c]);
    if (has_sigma_) {
      for (const Column& c : columns())
        if (c.kind == Column::Kind::sigma) table_.sigma[c.index].push_back(row_sigma_[c.index]);
    }
    table_.lines.push_back(static_cast<std::uint32_t>(reader_.line()));
    if (is_long_) bands_.push_back(band_);
  }

  LineReader reader_;
  bool need_values_;
  SampleTable table_;
  Dialect dialect_;
  Columns header_;
  std::vector<std::string_view> fields_;
  double angles_[4] = {}, largest_[4] = {};  // of this row; magnitudes in the file so far
  RawMagnitudes raw_[4];
  std::vector<double> row_values_, row_sigma_;
  ColumnQuantity quantity_ = ColumnQuantity::brdf;
  bool has_sigma_ = false, is_long_ = false, has_units_ = false;
  std::string last_comment_;  // above the header row
  Band band_;                 // of this row
  std::vector<Band> bands_;
};

}  // namespace

SampleTable read_csv(const Content& text, bool need_values) {
  return CsvReader(text, need_values).read();
}

void write_samples(std::ostream& out, const SampleTable& table, std::string_view quantity) {
  check_table(table);
  std::string text;
  for (const Comment& comment : table.metadata) text += "# " + comment_text(comment) + '\n';
  (((text += "# ") += kQuantityKey) += ": ") += quantity;
  text += '\n';
  for (const std::string_view angle : kAngleNames) (text += angle) += ',';
  for (const std::string& channel : table.channels) (text += channel) += ',';
  for (std::size_t c = 0; c < table.channels.size(); ++c)
    if (table.has_sigma(c)) ((text += kSigmaPrefix) += table.channels[c]) += ',';
  text.back() = '\n';
  for (std::size_t k = 0; k < table.rows(); ++k) {
    for (const double angle : {table.theta_i[k], table.phi_i[k], table.theta_o[k], table.phi_o[k]}) {
      append_number(text, angle);
      text += ',';
    }
    for (const auto& column : table.values) {
      append_number(text, column[k]);
      text += ',';
    }
    for (const auto& column : table.sigma) {
      if (column.empty()) continue;
      append_number(text, column[k]);
      text += ',';
    }
    text.back() = '\n';
    if (text.size() > (1 << 16)) {
      out.write(text.data(), static_cast<std::streamsize>(text.size()));
      text.clear();
    }
  }
  out.write(text.data(), static_cast<std::streamsize>(text.size()));
}

void write_samples(const std::filesystem::path& path, const SampleTable& table, std::string_view quantity) {
  write_file_atomically(path, [&](std::ostream& out) { write_samples(out, table, quantity); });
}

}  // namespace brdf::io
