#include "io/csv/csv_header.h"

#include <algorithm>
#include <unordered_set>

#include "io/colour/channel_colours.h"
#include "io/columns/angle_names.h"
#include "io/columns/no_number.h"
#include "io/columns/plain_names.h"
#include "io/columns/wavelengths.h"
#include "io/csv/number_streams.h"
#include "io/files/error.h"
#include "io/samples/table_rules.h"

namespace brdf::io {
namespace {

using Fields = std::vector<std::string_view>;

constexpr std::size_t kMostTitles = 60;  // most lines above the header row
constexpr std::size_t kRowsAhead = 50;   // rows from which columns of text are detected

bool is_number(Dialect& dialect, std::string_view field) {
  double number;
  return dialect.parse(field, number);
}

bool all_numbers(Dialect dialect, std::string_view line) {
  Fields fields;
  return dialect.split_header(line, fields) &&
         std::ranges::all_of(fields, [&](std::string_view f) { return is_number(dialect, f); });
}

// The characters with which programs open comments, apart from '#'.
constexpr std::string_view kOtherSigns = "%!/";

// Names and units may be in two separate rows. Adds the units to the names, as in "theta_i (deg)". Returns
// false if the fields are not units.
bool add_units(Dialect& dialect, const Fields& fields, std::vector<std::string>& names) {
  const auto is_one = [&](std::string_view field) { return !is_number(dialect, field) && is_unit(field); };
  if (fields.size() != names.size() || !std::ranges::all_of(fields, is_one) ||
      std::ranges::all_of(fields, [](std::string_view f) { return f.empty(); }))
    return false;
  for (std::size_t k = 0; k < names.size(); ++k) {
    const std::string_view unit = fields[k];
    if (unit.empty() || unit == "-") continue;
    const bool has_brackets = unit.front() == '[' || unit.front() == '(';
    names[k] += has_brackets ? " " + std::string(unit) : " (" + std::string(unit) + ")";
  }
  return true;
}

}  // namespace

void CsvHeader::fail(const std::string& what) const {
  throw InputError(reader_.where() + ": " + what);
}

// Returns whether the line is a header row beyond doubt. Lines above such a row are titles. A line of too
// many fields counts as a header row, which is refused. Below a line that states an angle, a header row names
// only one.
bool CsvHeader::is_header(std::string_view line, bool has_stated_angle) const {
  Fields names;
  Dialect dialect = dialect_;
  return dialect.split_header(line, names) &&
         (names.size() > kWidestTable || names_angles(names) || matrix_header(names, dialect) ||
          (has_stated_angle && names.size() > 1 && names_angles(names, 1) && !stated_angle(line)));
}

// Returns a header row behind such characters ("% theta_i, phi_i, ...") without them, and any other line
// unchanged.
std::string_view CsvHeader::behind_sign(std::string_view line, bool has_stated_angle) const {
  const std::string_view bare =
      trimmed(line.substr(std::min(line.size(), line.find_first_not_of(kOtherSigns))));
  return bare.size() < line.size() && is_header(bare, has_stated_angle) ? bare : line;
}

void CsvHeader::read_comment(std::string_view line) {
  const std::string_view text = line.substr(comment_sign().size());
  if (!is_read()) {
    last_comment_ = trimmed(text);
    last_comment_line_ = reader_.line();
  }
  const auto words = quantity_in_comment(text);
  is_read() ? refuse_other_angle(text) : stated_angles_.add(text, reader_.line());
  if (!words) {
    keep_comment(table_, parse_comment(text));
    if (!is_read()) stated_.add_scale(std::string(text), reader_.line());
    if (!is_read() && table_.metadata.back().first.empty())
      stated_.add_free_text(table_.metadata.back().second, reader_.line());
    return;
  }
  if (layout_ && layout_->quantity) return compare_with_layout(*words);
  // The line is not stored as a comment, because the table holds f_r whatever the file held.
  if (is_read()) fail("the quantity must be stated before the header row");
  stated_.add_comment(*words, reader_.line(), reader_.where());
}

bool CsvHeader::is_header_in_comment(std::string_view line) const {
  Dialect of_numbers, of_names;
  Fields fields, names;
  if (!of_numbers.split_header(line, fields) || fields.empty() || !is_number(of_numbers, fields[0]) ||
      !of_names.split_header(last_comment_, names))
    return false;
  return has_plain_angle_names(names) ||
         (names.size() == fields.size() && names.size() <= kWidestTable && names_angles(names));
}

bool CsvHeader::is_other_comment(std::string_view line) const {
  return !layout_ && (line.starts_with('%') || line.starts_with('!') || line.starts_with("//"));
}

void CsvHeader::keep_other_comment(std::string_view line) {
  const std::size_t text = std::min(line.size(), line.find_first_not_of(kOtherSigns));
  refuse_other_angle(line.substr(text));
  keep_comment(table_, parse_comment(": " + std::string(trimmed(line.substr(text)))));
}

bool CsvHeader::read(std::string_view line) {
  if (layout_) return read_by_layout(line);
  if (!is_header_in_comment(line)) {
    read_names(behind_titles(line));
    return false;
  }
  table_.metadata.pop_back();
  read_names(last_comment_);
  columns_.notes.push_back("the header row is the comment above the numbers");
  return true;
}

// Returns whether the line states an angle and words follow. The line is then a title: as the header row of a
// matrix with one column, numbers would follow.
bool CsvHeader::is_above_words(std::string_view line) const {
  if (!stated_angle(line)) return false;
  LineReader ahead = reader_;
  for (std::string_view next; ahead.next(next);)
    if (next = trimmed(next); !next.empty() && next.front() != '#') return !all_numbers(dialect_, next);
  return false;
}

// Skips lines without '#' above the header row, as instruments write them, and returns the header row. The
// lines become comments and may name the quantity.
std::string_view CsvHeader::behind_titles(std::string_view line) {
  bool has_stated_angle = !stated_angles_.is_empty();
  line = behind_sign(line, has_stated_angle);
  if (is_header(line, has_stated_angle) && !is_above_words(line)) return line;
  has_stated_angle = has_stated_angle || stated_angle(line);
  LineReader ahead = reader_;
  std::size_t titles = 1;
  bool found = false;
  for (std::string_view next; !found && titles <= kMostTitles && ahead.next(next);) {
    next = trimmed(next);
    if (next.empty() || next.front() == '#') continue;
    if (all_numbers(dialect_, next)) return line;
    found = is_header(behind_sign(next, has_stated_angle), has_stated_angle);
    has_stated_angle = has_stated_angle || stated_angle(next);
    titles += !found;
  }
  if (!found) return line;
  add_title(line);
  for (std::string_view next; reader_.next(next);) {
    next = trimmed(next);
    if (next.empty()) continue;
    if (reader_.line() == ahead.line()) {
      table_.warnings.push_back(std::to_string(titles) + (titles == 1 ? " line" : " lines") +
                                " above the header row interpreted as titles");
      return behind_sign(next, has_stated_angle);
    }
    next.front() == '#' ? read_comment(next) : add_title(next);
  }
  return line;
}

void CsvHeader::add_title(std::string_view title) {
  if (const auto words = quantity_in_comment(title))
    return layout_ && layout_->quantity ? compare_with_layout(*words)
                                        : stated_.add_comment(*words, reader_.line(), reader_.where());
  if (!layout_) stated_.add_title(title, reader_.line(), reader_.where());
  stated_.add_scale(std::string(title), reader_.line());
  stated_angles_.add(title, reader_.line());
  const Comment pair = parse_comment(title);
  constexpr std::size_t kLongestKey = 40;
  const bool has_key =
      !pair.first.empty() && pair.first.size() <= kLongestKey && title.find(": ") == title.find(':');
  keep_comment(table_, has_key ? pair : parse_comment(": " + std::string(title)));
}

void CsvHeader::read_names(std::string_view line) {
  Fields fields;
  if (!dialect_.split_header(line, fields)) fail(std::string(kBadQuotation));
  check_width(fields.size());
  check_lengths(fields);
  if (read_matrix(fields)) return;
  written_names_.assign(fields.begin(), fields.end());
  if (!doubts_) check_names(fields);
  std::vector<std::string> names(fields.begin(), fields.end());
  HeaderFacts facts{reader_.where(), stated_.result(), need_values_, {}};
  facts.doubts = doubts_;
  facts.stated_angles = &stated_angles_;
  look_ahead(names, facts);
  columns_ = understand_columns({names.begin(), names.end()}, facts);
  if (columns_.has_unnamed && !doubts_)
    if (const std::string word = stated_.word_on_unnamed(); !word.empty()) columns_.assume(word);
  if (has_unscaled_values() && !doubts_)
    if (const std::string word = stated_.word_on_scale(); !word.empty()) columns_.assume(word);
  is_long_ = columns_.has(Column::Kind::wavelength) || columns_.has(Column::Kind::polarisation);
  if (doubts_) return;
  check_columns();
  table_.channels = columns_.channels;
  check_channel_names(table_.channels, facts.where);
}

// Returns whether the values of a channel are read without a factor and without a logarithm.
bool CsvHeader::has_unscaled_values() const {
  return std::ranges::any_of(columns_.quantities, [](const Quantity& q) { return q == Quantity{q.kind}; });
}

// Refuses a comment between the rows that states another angle than the lines above the header row.
void CsvHeader::refuse_other_angle(std::string_view text) const {
  if (layout_ || columns_.constants.empty()) return;
  const auto stated = stated_angle(text);
  if (!stated) return;
  const double degrees = stated->degrees();
  for (const auto& [column, number] : columns_.constants)
    if (!column.name.empty() && column.index == stated->column.index && column.converted(number) != degrees)
      fail(shown(stated->column.name) + " is " + to_text(degrees) + " degrees here, and " +
           to_text(column.converted(number)) + " above the header row: add a column '" +
           std::string(kAngleNames[column.index]) + "' with the angle of each row");
}

// Names are searched for quantities and units from each separator on, so that a hostile name would take a
// time that grows with the square of its length.
void CsvHeader::check_lengths(std::span<const std::string_view> names) const {
  constexpr std::size_t kLongestHeading = 500;  // bytes
  for (std::size_t k = 0; k < names.size(); ++k)
    if (names[k].size() > kLongestHeading)
      fail("the name of column " + std::to_string(k + 1) + " has " + std::to_string(names[k].size()) +
           " bytes, which exceed the limit of " + std::to_string(kLongestHeading));
}

void CsvHeader::check_width(std::size_t columns) const {
  if (columns > kWidestTable)
    fail(std::to_string(columns) + " columns exceed the limit of " + std::to_string(kWidestTable));
}

bool CsvHeader::has_numbers_only(const Fields& fields, std::size_t first) const {
  Dialect probe = dialect_;
  return first < fields.size() &&
         std::all_of(fields.begin() + static_cast<std::ptrdiff_t>(first), fields.end(),
                     [&](std::string_view f) { return is_number(probe, f); });
}

void CsvHeader::check_names(const Fields& fields) const {
  const bool has_names =
      std::ranges::any_of(fields, [&](std::string_view name) { return !is_number(dialect_, name); });
  std::unordered_set<std::string_view> seen;
  for (std::size_t k = 0; k < fields.size(); ++k) {
    const std::string at = "column " + std::to_string(k + 1);
    if (fields[k].empty() && fields.size() > 2 && has_numbers_only(fields, k + 1))
      fail(at +
           " has no name; in a matrix of two angles the first cell names both angles (theta_o \\ theta_i), "
           "or 'tan gamma \\ beta' in an r-table of road lighting");
    if (fields[k].empty()) fail(at + " has no name; remove a column of row numbers");
    const bool is_band = has_names && with_band_unit(fields[k]) != fields[k];
    if (!is_band && is_number(dialect_, fields[k])) refuse_numbers(fields, k);
    if (!seen.insert(fields[k]).second)
      fail("column " + shown(fields[k]) +
           " twice; write repeat measurements as separate rows, and give each channel its own name");
  }
}

// Refuses a number in place of a name.
void CsvHeader::refuse_numbers(const Fields& fields, std::size_t k) const {
  Dialect probe = dialect_;
  if (k == 0 || is_number(probe, fields[0]))
    fail("the header row is missing: column " + std::to_string(k + 1) + " is the number " + shown(fields[k]) +
         ", not a name; " + header_for_numbers(reader_.content(), fields));
  Fields axes;
  split(fields[0], '\\', axes);
  for (const std::string_view axis : axes)
    if (const auto refused = refused_angle(axis)) fail("column " + shown(fields[0]) + " " + refused->reason);
  fail("column " + std::to_string(k + 1) + " is the number " + shown(fields[k]) +
       ", not a name; in a matrix of two angles the first cell names both angles (theta_o \\ theta_i), or "
       "the angle of the first column");
}

bool CsvHeader::read_matrix(const Fields& names) {
  matrix_ = matrix_header(names, dialect_);
  if (!matrix_) return false;
  columns_.columns = {matrix_->rows, matrix_->columns};
  columns_.channels = table_.channels = {"fr"};
  columns_.in_plane = !matrix_->is_road;
  if (matrix_->is_road) {
    describe_road_table();
    return true;
  }
  const auto& stated = stated_.result();
  columns_.quantities = {stated ? stated->quantity : Quantity{&quantity_kinds()[0]}};
  const bool is_light_down = matrix_->rows.index == 0;
  columns_.notes.push_back(std::string("a matrix: ") +
                           (is_light_down ? "angles of incidence" : "viewing angles") +
                           " in the first column, " +
                           (is_light_down ? "viewing angles" : "angles of incidence") + " in the first row");
  if (const std::string word = stated_.word_on_unnamed(); !word.empty()) columns_.assume(word);
  if (const std::string word = stated_.word_on_scale(); !word.empty()) columns_.assume(word);
  if (!stated)
    columns_.assume("the values are interpreted as f_r in 1/sr, because the matrix gives no quantity");
  else if (!stated->quantity.is_f_r())
    columns_.assume("the values of the matrix are " + stated->quantity.meaning() + ": " +
                    stated->quantity.operation());
  return true;
}

// An r-table of road lighting holds reduced luminance coefficients, unless a comment states otherwise.
void CsvHeader::describe_road_table() {
  const auto& stated = stated_.result();
  const Quantity quantity = stated ? stated->quantity : *quantity_named("r");
  columns_.quantities = {quantity};
  columns_.assume(
      "an r-table of road lighting: the tangent of the angle of incidence and the azimuth beta (0: "
      "mirror side), for a viewer 1 degree above the road (theta_o = 89); the values are " +
      quantity.meaning() + ": " + quantity.operation());
  columns_.notes.push_back("fit and study need --max-theta 90 for this table");
}

// Looks ahead to find units in a row of their own, which is skipped, and columns of text.
void CsvHeader::look_ahead(std::vector<std::string>& names, HeaderFacts& facts) {
  facts.is_text.assign(names.size(), true);
  std::vector<bool> has_text(names.size());
  LineReader ahead = reader_;
  Dialect dialect = dialect_;
  Fields fields;
  bool is_first = true;
  for (std::size_t rows = 0; rows < kRowsAhead;) {
    std::string_view line;
    if (!ahead.next(line)) break;
    line = trimmed(line);
    if (line.empty() || line.front() == '#') continue;
    if (!dialect.split_row(line, fields) || fields.size() != names.size()) break;
    if (std::exchange(is_first, false) && add_units(dialect, fields, names)) {
      reader_ = ahead;
      continue;
    }
    ++rows;
    for (std::size_t k = 0; k < fields.size(); ++k) {
      const bool number = is_number(dialect, fields[k]) || dialect.marks_are_mixed();
      facts.is_text[k] = facts.is_text[k] && !number;
      has_text[k] = has_text[k] || (!number && advice_on(fields[k]).empty());
    }
  }
  for (std::size_t k = 0; k < names.size(); ++k) facts.is_text[k] = facts.is_text[k] && has_text[k];
}

// Returns whether the header row consists of words between blanks, without any angle.
bool CsvHeader::is_a_title() const {
  return dialect_.separates_by_blanks() && std::ranges::none_of(columns_.columns, [](const Column& c) {
           return c.kind == Column::Kind::angle;
         });
}

// Returns a clause about the first column whose quantity is no f_r, for a table without angles.
std::string CsvHeader::refused_values() const {
  for (const Column& c : columns_.columns) {
    const NamedQuantity named = quantity_of_column(c.name);
    if (c.kind == Column::Kind::value && named.says == NamedQuantity::Says::quantity &&
        named.quantity.kind->use == QuantityKind::Use::refused)
      return "; column " + shown(c.name) + " " + refusal_of(*named.quantity.kind);
  }
  return "";
}

void CsvHeader::check_columns() const {
  std::string found;
  for (const Column& c : columns_.columns) found += (found.empty() ? "" : ", ") + shown(c.name);
  for (const std::size_t angle : {0, 2})
    if (!columns_.has_angle(angle))
      fail("column '" + std::string(kAngleNames[angle]) +
           "' is missing (theta_i,phi_i,theta_o,phi_o,<channel>...); found, separated by " +
           dialect_.separator_in_words() + ": " + found +
           (!refused_values().empty() ? refused_values()
            : is_a_title()            ? "; lines above the header row begin with '#'"
            : columns_.has_angle(2 - angle)
                ? std::string("; no column has the ") +
                      (angle == 0 ? "angle of incidence" : "viewing angle") +
                      ", and no line above states it, as in '# " + std::string(kAngleNames[angle]) + ": 45'"
                : ""));
  if (need_values_ && columns_.channels.empty()) {
    std::string others;
    for (const Column& c : columns_.columns)
      if (c.kind != Column::Kind::angle) others += (others.empty() ? "" : ", ") + shown(c.name);
    fail("no value column in addition to the four angles" +
         (others.empty() ? "" : "; the other columns are not values: " + others));
  }
  if (is_long_ && need_values_ && columns_.channels.size() != 1)
    fail("a column of " +
         std::string(columns_.has(Column::Kind::wavelength) ? "wavelengths" : "polarisations") +
         " needs one column of values, not " + std::to_string(columns_.channels.size()));
  for (const auto& [kind, name] : {std::pair(Column::Kind::wavelength, "wavelengths"),
                                   std::pair(Column::Kind::polarisation, "polarisations"),
                                   std::pair(Column::Kind::rotation, "sample rotations")})
    if (std::ranges::count_if(columns_.columns, [kind = kind](const Column& c) { return c.kind == kind; }) >
        1)
      fail(std::string("two columns of ") + name);
}

}  // namespace brdf::io
