#include "io/formats/astm.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "io/colour/channel_colours.h"
#include "io/columns/metadata_names.h"
#include "io/columns/plain_names.h"
#include "io/columns/supplied.h"
#include "io/columns/value_columns.h"
#include "io/files/content.h"
#include "io/files/error.h"
#include "io/files/output.h"
#include "io/files/text.h"
#include "io/samples/table_rules.h"
#include "io/samples/to_f_r.h"

namespace brdf::io::astm {
namespace {

constexpr std::string_view kAngles[] = {"theta_i", "phi_i", "theta_s", "phi_s"};
constexpr std::string_view kKeyword = "VARS", kUnit = "ANGLE_UNIT", kQuantity = "QUANTITY";

bool is_keyword_line(std::string_view line, std::string_view keyword) {
  return line.starts_with(keyword) && line.size() > keyword.size() &&
         (line[keyword.size()] == ' ' || line[keyword.size()] == '\t');
}

class AstmReader {
 public:
  AstmReader(const Content& text, const Supplied& supplied)
      : reader_(text), stated_(stated_by_option(supplied.quantity)) {
    refuse_mirror_side(text.name, supplied);
    table_.source = text.name;
    table_.format = "astm_e1392";
  }

  SampleTable read() {
    read_keywords();
    std::string_view line;
    while (reader_.next(line)) {
      line = trimmed(line);
      if (line.empty()) continue;
      split(line, ',', fields_);
      if (!is_laid_out_) lay_out();
      read_row();
    }
    if (table_.rows() == 0) throw InputError(table_.source + ": no rows after VARS");
    to_degrees();
    make_f_r(table_, header_.quantities);
    return std::move(table_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { throw InputError(reader_.where() + ": " + what); }

  void read_keywords() {
    std::string_view line;
    while (reader_.next(line)) {
      line = trimmed(line);
      if (is_keyword_line(line, kKeyword)) {
        split(line.substr(kKeyword.size()), ',', fields_);
        if (fields_.size() > 2 * kMostChannels + std::size(kAngles))
          fail("VARS names " + std::to_string(fields_.size()) + " columns, more than 4 angles and " +
               std::to_string(kMostChannels) + " channels with their standard deviations");
        for (const std::string_view name : fields_)
          names_.emplace_back(name == "theta_o" ? "theta_s" : name == "phi_o" ? "phi_s" : name);
        return;
      }
      const std::size_t blank = line.find_first_of(" \t");
      if (blank == line.npos) continue;
      std::string_view value = trimmed(line.substr(blank));
      if (value.size() > 1 && value.front() == '"' && value.back() == '"')
        value = value.substr(1, value.size() - 2);
      if (line.substr(0, blank) == kUnit && (value == "degrees" || value == "radians")) {
        is_radians_ = value == "radians";
        continue;
      }
      if (line.substr(0, blank) == kQuantity && quantity_named(value))
        stated_.add_comment(value, reader_.line(), reader_.where());
      else
        table_.add_comment(line.substr(0, blank), value);
    }
    throw InputError(table_.source + ": no VARS line");
  }

  // Finds the column of each angle from the names and the length of the first row.
  void lay_out() {
    is_laid_out_ = true;
    std::size_t missing = 0;
    for (const std::string_view angle : kAngles) missing += std::ranges::find(names_, angle) == names_.end();
    if (missing > 1) fail("VARS names fewer than three of theta_i, phi_i, theta_s, phi_s");
    if (missing == 1 && fields_.size() == names_.size() + 1) insert_missing_angle();
    if (fields_.size() != names_.size())
      fail(std::to_string(fields_.size()) + " columns, but VARS names " + std::to_string(names_.size()));
    for (std::size_t k = 0; k < names_.size(); ++k) {
      const auto angle = std::find(std::begin(kAngles), std::end(kAngles), names_[k]);
      Column column;
      column.name = names_[k];
      if (angle != std::end(kAngles)) {
        column_[angle - kAngles] = static_cast<int>(k);
        column.kind = Column::Kind::angle;
      }
      header_.columns.push_back(std::move(column));
    }
    place_columns();
    if (column_[0] < 0 || column_[2] < 0) fail("both polar angles, theta_i and theta_s, are required");
    if (value_columns_.empty()) fail("VARS names no column of values");
    for (const int k : {1, 3}) {
      if (column_[k] >= 0) continue;
      table_.assume(std::string(kAngles[k]) + " is not in the file; assumed " +
                    (k == 1 ? "180 degrees" : "0 degrees"));
    }
  }

  // Assigns the columns that are not angles, by the same rules as in any other table.
  void place_columns() {
    const auto& stated = stated_.result();
    HeaderFacts facts{reader_.where(), stated};
    facts.is_plain = facts.is_format = true;
    facts.keeps_names = stated && stated->by == StatedQuantity::By::comment && stated->quantity.is_f_r();
    place_values(header_, facts, [](std::string_view, const std::string&) {});
    table_.set_channels(header_.channels);
    for (const std::string& note : header_.assumptions) table_.assume(note);
    check_channel_names(table_.channels, reader_.where());
    value_columns_.resize(table_.channels.size());
    sigma_columns_.resize(table_.channels.size());
    for (std::size_t k = 0; k < names_.size(); ++k) {
      const Column& column = header_.columns[k];
      if (column.kind == Column::Kind::value) value_columns_[column.index] = k;
      if (column.kind != Column::Kind::sigma) continue;
      if (sigma_columns_[column.index]) fail("column " + shown(names_[k]) + " twice");
      sigma_columns_[column.index] = k;
    }
  }

  void insert_missing_angle() {
    for (std::size_t k = 0; k < 4; ++k) {
      if (std::ranges::find(names_, kAngles[k]) != names_.end()) continue;
      names_.insert(names_.begin() + static_cast<std::ptrdiff_t>(k), std::string(kAngles[k]));
      table_.assume("VARS omits the name " + std::string(kAngles[k]) + ": column " + std::to_string(k + 1) +
                    " is interpreted as this angle");
      return;
    }
  }

  double number(std::size_t column) const {
    double value;
    if (!parse_number(fields_[column], value) || !std::isfinite(value))
      fail("column " + std::to_string(column + 1) + " (" + names_[column] + "): " + shown(fields_[column]) +
           " is not a finite number");
    return value;
  }

  void read_row() {
    if (fields_.size() != names_.size())
      fail(std::to_string(fields_.size()) + " columns, but the first row has " +
           std::to_string(names_.size()));
    if (table_.rows() == kMostRows) fail("more than " + std::to_string(kMostRows) + " rows");
    std::vector<double>* const angles[] = {&table_.theta_i, &table_.phi_i, &table_.theta_o, &table_.phi_o};
    for (std::size_t k = 0; k < 4; ++k)
      angles[k]->push_back(column_[k] < 0 ? 0.0 : number(static_cast<std::size_t>(column_[k])));
    for (std::size_t k = 0; k < 4; ++k)
      if (column_[k] >= 0) raw_[k].add(angles[k]->back());
    for (std::size_t c = 0; c < value_columns_.size(); ++c) {
      table_.values[c].push_back(number(value_columns_[c]));
      if (sigma_columns_[c]) table_.sigma[c].push_back(number(*sigma_columns_[c]));
    }
    table_.lines.push_back(static_cast<std::uint32_t>(reader_.line()));
  }

  void store_raw_angles() {
    for (std::size_t k = 0; k < 4; ++k) {
      if (column_[k] < 0) continue;
      RawAngle& angle = table_.raw_angles[k];
      angle.name = names_[static_cast<std::size_t>(column_[k])];
      angle.has_unit = is_radians_.has_value();
      std::move(raw_[k]).store(angle);
    }
  }

  // Returns whether the angles may be radians, which reach pi/2 in a polar angle and a full turn, to either
  // side, in an azimuth. The tolerance allows for files that print few digits.
  bool may_be_radians() const {
    constexpr double kRound = 1 + 1e-6;
    const RawAngles& raw = table_.raw_angles;
    return std::max(raw[0].largest, raw[2].largest) <= std::numbers::pi / 2 * kRound &&
           std::max(raw[1].largest, raw[3].largest) <= 2 * std::numbers::pi * kRound;
  }

  void to_degrees() {
    store_raw_angles();
    const bool is_radians = is_radians_.value_or(may_be_radians());
    const double scale = is_radians ? 180 / std::numbers::pi : 1.0;
    const std::string unit = is_radians ? "radians" : "degrees";
    if (!is_radians_) table_.assume("angles are assumed to be in " + unit);
    for (std::size_t k = 0; k < table_.rows(); ++k) {
      table_.phi_i[k] = column_[1] < 0 ? 180.0 : table_.phi_i[k] * scale;
      table_.phi_o[k] = column_[3] < 0 ? 0.0 : table_.phi_o[k] * scale;
      unfold(table_.theta_i[k], table_.phi_i[k], scale, k);
      unfold(table_.theta_o[k], table_.phi_o[k], scale, k);
    }
  }

  void unfold(double& theta, double& phi, double scale, std::size_t row) const {
    theta *= scale;
    if (theta < 0) {
      theta = -theta;
      phi += 180;
    }
    if (theta > 90 * (1 + 1e-6))
      throw InputError(table_.where(row) + ": polar angle " + to_text(theta) + " is below the horizon");
    theta = std::min(theta, 90.0);
  }

  LineReader reader_;
  SampleTable table_;
  std::vector<std::string> names_;
  std::vector<std::string_view> fields_;
  std::vector<std::size_t> value_columns_;
  std::vector<std::optional<std::size_t>> sigma_columns_;  // [channel]
  std::optional<bool> is_radians_;                         // if the file states the unit
  StatedQuantities stated_;
  Columns header_;
  int column_[4] = {-1, -1, -1, -1};
  RawMagnitudes raw_[4];
  bool is_laid_out_ = false;
};

}  // namespace

constexpr std::size_t kLongestHeader = 1000;  // lines

bool recognises(const Content& text) {
  LineReader reader(text);
  std::string_view line;
  while (reader.line() < kLongestHeader && reader.next(line)) {
    line = trimmed(line);
    if (is_keyword_line(line, kKeyword)) return true;
    if (line.starts_with('#') || line.starts_with("theta_i")) return false;  // a CSV file
  }
  return false;
}

SampleTable read(const Content& text, const Supplied& supplied) {
  return AstmReader(text, supplied).read();
}

namespace {

// Returns whether a comment, written as a keyword line, reads back unchanged and is not mistaken for
// something else.
bool is_keyword(const Comment& comment) {
  const auto& [key, value] = comment;
  return !key.empty() && key.find_first_of(" \t#{\"") == key.npos && key != kKeyword && key != kUnit &&
         key != kQuantity && !key.starts_with(kAngles[0]) && key != kQuantityKey &&
         printable(key + value) == key + value;
}

// Returns whether the name of a channel, read as a column name, would be taken for a quantity other than
// f_r.
bool says_other(const std::string& channel) {
  const NamedQuantity named = quantity_of_column(channel);
  const bool is_f_r = named.says == NamedQuantity::Says::quantity && named.quantity.is_f_r();
  return holds_no_values(channel) != NoValues::no || named.name != channel ||
         !(named.says == NamedQuantity::Says::nothing || is_f_r);
}

// Appends the rows. Angles are in degrees, as in the table.
void append_rows(const SampleTable& table, std::string& text) {
  for (std::size_t k = 0; k < table.rows(); ++k) {
    for (const double angle : {table.theta_i[k], table.phi_i[k], table.theta_o[k], table.phi_o[k]}) {
      append_number(text, angle);
      text += ',';
    }
    for (const auto* columns : {&table.values, &table.sigma})
      for (const std::vector<double>& column : *columns) {
        if (column.empty()) continue;
        append_number(text, column[k]);
        text += ',';
      }
    text.back() = '\n';
  }
}

}  // namespace

std::vector<std::string> write(const std::filesystem::path& path, const SampleTable& table) {
  check_table(table);
  if (table.rows() == 0) throw InputError(table.name() + ": holds no rows");
  std::string text;
  (text += kUnit) += " degrees\n";
  if (std::ranges::any_of(table.channels, says_other)) (text += kQuantity) += " f_r\n";
  std::size_t lost = 0, lines = 2;
  for (const Comment& comment : table.metadata) {
    if (is_keyword(comment) && lines++ < kLongestHeader)
      text += comment.first + " \"" + comment.second + "\"\n";
    else
      ++lost;
  }
  text += kKeyword;
  text += ' ';
  for (const std::string_view angle : kAngles) (text += angle) += ',';
  for (const std::string& channel : table.channels) {
    if (std::find(std::begin(kAngles), std::end(kAngles), channel) != std::end(kAngles))
      throw InputError(table.name() + ": channel " + shown(channel) +
                       " is the name of an angle in ASTM E1392");
    (text += channel) += ',';
  }
  for (std::size_t c = 0; c < table.channels.size(); ++c)
    if (table.has_sigma(c)) ((text += kSigmaPrefix) += table.channels[c]) += ',';
  text.back() = '\n';
  append_rows(table, text);
  write_file_atomically(path, text);
  if (lost == 0) return {};
  return {std::to_string(lost) + " comments that are not a keyword with a value"};
}

}  // namespace brdf::io::astm
