#include "io/csv.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <ostream>
#include <unordered_map>
#include <unordered_set>

#include "io/error.h"
#include "io/output.h"
#include "io/table_rules.h"
#include "io/text.h"

namespace brdf::io {
namespace {

enum class Quantity { brdf, brdf_cos_i, brdf_cos_o };

// What a column holds: an angle, a channel's value, or its standard deviation.
struct Column {
  enum class Kind { angle, value, sigma } kind;
  std::size_t index;
  std::string name;
};

// Whether a column holds wavelengths: `wavelength`, `lambda` or `wl`, with or without a unit.
bool is_wavelength(std::string_view name) {
  std::string word = lower_case(name);
  const std::size_t end = word.find_first_of("_ ([/");
  const std::string unit = end == word.npos ? "" : word.substr(end + 1);
  word = word.substr(0, end);
  const bool is_unit = unit.empty() || unit.starts_with("nm") || unit.starts_with("um");
  return is_unit && (word == "wavelength" || word == "wavelengths" || word == "lambda" || word == "wl");
}

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
      else if (columns_.empty())
        read_header(line);
      else
        read_row(line);
    }
    if (columns_.empty())
      throw InputError(table_.source + ": no header row (theta_i,phi_i,theta_o,phi_o,<channel>...)");
    if (table_.rows() == 0) throw InputError(table_.source + ": holds no rows");
    if (table_.skipped > 0)
      table_.warnings.push_back(std::to_string(table_.skipped) +
                                " rows left out: f_r is undefined where the quantity's cosine is 0");
    return std::move(table_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { throw InputError(reader_.where() + ": " + what); }
  [[noreturn]] void fail(std::size_t column, std::string_view text, const std::string& rule) const {
    fail("column " + std::to_string(column + 1) + " (" + columns_[column].name + "): " + shown(text) + " " +
         rule);
  }

  void read_comment(std::string_view line) {
    Comment comment = parse_comment(line.substr(1));
    if (comment.first == kQuantityKey)
      read_quantity(comment.second);  // and no comment: the table holds f_r whatever the file held
    else
      table_.metadata.push_back(std::move(comment));
  }

  void read_quantity(const std::string& value) {
    if (!columns_.empty()) fail("the quantity must be stated before the header row");
    std::string name;
    std::copy_if(value.begin(), value.end(), std::back_inserter(name), [](char c) { return c != ' '; });
    if (name == "f_r*cos_i")
      quantity_ = Quantity::brdf_cos_i;
    else if (name == "f_r*cos_o")
      quantity_ = Quantity::brdf_cos_o;
    else if (name != "f_r")
      fail("quantity " + shown(value) + " is unknown (known: f_r, f_r*cos_i, f_r*cos_o)");
  }

  void read_header(std::string_view line) {
    split(line, ',', fields_);
    std::unordered_set<std::string_view> seen;
    for (const std::string_view name : fields_) {
      if (name.empty()) fail("column " + std::to_string(columns_.size() + 1) + " has no name");
      double number;
      if (parse_number(name, number))
        fail("the header row is missing: column " + std::to_string(columns_.size() + 1) + " is the number " +
             shown(name) + ", not a name");
      if (!seen.insert(name).second) fail("column " + shown(name) + " twice");
      if (is_wavelength(name))
        fail("column " + shown(name) +
             ": the long format, one row for each wavelength, is not read; give each wavelength a column of "
             "its "
             "own, such as 465nm");
      const auto angle = std::find(std::begin(kAngleNames), std::end(kAngleNames), name);
      if (angle != std::end(kAngleNames)) {
        columns_.push_back(
            {Column::Kind::angle, static_cast<std::size_t>(angle - kAngleNames), std::string(name)});
      } else if (name.starts_with(kSigmaPrefix)) {
        columns_.push_back({Column::Kind::sigma, 0, std::string(name)});
      } else {
        columns_.push_back({Column::Kind::value, table_.channels.size(), std::string(name)});
        table_.channels.emplace_back(name);
      }
    }
    check_channel_names(table_.channels, reader_.where());
    check_header();
    table_.values.resize(table_.channels.size());
    table_.sigma.resize(table_.channels.size());
    row_values_.resize(table_.channels.size());
    row_sigma_.resize(table_.channels.size());
  }

  void check_header() {
    for (const std::string_view angle : kAngleNames) {
      const auto same = [&](const Column& c) { return c.name == angle; };
      if (std::none_of(columns_.begin(), columns_.end(), same))
        fail("column '" + std::string(angle) + "' is missing (theta_i,phi_i,theta_o,phi_o,<channel>...)");
    }
    if (need_values_ && table_.channels.empty()) fail("no value column beside the four angles");
    std::unordered_map<std::string_view, std::size_t> channel;
    for (std::size_t c = 0; c < table_.channels.size(); ++c) channel[table_.channels[c]] = c;
    for (Column& c : columns_) {
      if (c.kind != Column::Kind::sigma) continue;
      const auto found = channel.find(std::string_view(c.name).substr(kSigmaPrefix.size()));
      if (found == channel.end()) fail("column " + shown(c.name) + " has no column of values");
      c.index = found->second;
      has_sigma_ = true;
    }
  }

  void read_row(std::string_view line) {
    split(line, ',', fields_);
    if (fields_.size() != columns_.size())
      fail(std::to_string(fields_.size()) + " columns where the header has " +
           std::to_string(columns_.size()));
    for (std::size_t k = 0; k < columns_.size(); ++k) {
      double number;
      if (!parse_number(fields_[k], number)) fail(k, fields_[k], "is not a number");
      if (!std::isfinite(number)) fail(k, fields_[k], "is not finite");
      switch (columns_[k].kind) {
        case Column::Kind::angle:
          largest_[columns_[k].index] = std::max(largest_[columns_[k].index], std::abs(number));
          if (columns_[k].index % 2 == 0 && std::abs(number) > 90.0) below_horizon(k);
          angles_[columns_[k].index] = number;
          break;
        case Column::Kind::value:
          row_values_[columns_[k].index] = number;
          break;
        case Column::Kind::sigma:
          if (!(number > 0.0)) fail(k, fields_[k], "must be above 0");
          row_sigma_[columns_[k].index] = number;
      }
    }
    store_row();
  }

  // Azimuths in the polar angle's column are told apart from a wrong angle: there are many of them, and the
  // other column never exceeds 90 degrees. Reads the rest of the file for that.
  [[noreturn]] void below_horizon(std::size_t column) {
    const std::size_t theta = columns_[column].index, phi = theta + 1;
    const std::string at = reader_.where() + ": column " + std::to_string(column + 1) + " (" +
                           columns_[column].name + "): " + shown(fields_[column]) + " ";
    std::size_t rows = table_.rows(), above = 0;
    bool first = true;
    for (std::string_view line; first || reader_.next(line); first = false) {
      if (!first) split(trimmed(line), ',', fields_);
      if (fields_.size() != columns_.size()) continue;
      for (std::size_t k = 0; k < columns_.size(); ++k) {
        double x;
        if (columns_[k].kind != Column::Kind::angle || !parse_number(fields_[k], x)) continue;
        largest_[columns_[k].index] = std::max(largest_[columns_[k].index], std::abs(x));
        above += columns_[k].index == theta && std::abs(x) > 90.0;
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
    if (quantity_ != Quantity::brdf) {
      const double cosine = cos_degrees(quantity_ == Quantity::brdf_cos_i ? angles_[0] : angles_[2]);
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
      for (const Column& c : columns_)
        if (c.kind == Column::Kind::sigma) table_.sigma[c.index].push_back(row_sigma_[c.index]);
    }
    table_.lines.push_back(static_cast<std::uint32_t>(reader_.line()));
  }

  LineReader reader_;
  bool need_values_;
  SampleTable table_;
  std::vector<Column> columns_;
  std::vector<std::string_view> fields_;
  double angles_[4] = {}, largest_[4] = {};  // of this row; magnitudes in the file so far
  std::vector<double> row_values_, row_sigma_;
  Quantity quantity_ = Quantity::brdf;
  bool has_sigma_ = false;
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
