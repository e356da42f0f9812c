#include "io/csv/csv.h"

#include <algorithm>
#include <cmath>

#include "io/columns/no_number.h"
#include "io/columns/plain_names.h"
#include "io/columns/wavelengths.h"
#include "io/csv/csv_header.h"
#include "io/csv/long_format.h"
#include "io/files/error.h"
#include "io/files/numbers.h"
#include "io/samples/aperture.h"
#include "io/samples/degrees.h"
#include "io/samples/fill_values.h"
#include "io/samples/mirror_side.h"
#include "io/samples/phase_angle.h"
#include "io/samples/to_f_r.h"

namespace brdf::io {
namespace {

class CsvReader {
 public:
  CsvReader(const Content& text, bool need_values, const Supplied& supplied)
      : reader_(text), supplied_(supplied), header_(reader_, dialect_, table_, need_values, supplied) {
    table_.source = text.name;
  }

  SampleTable read() {
    std::string_view whole;
    while (reader_.next(whole)) {
      const std::string_view line = trimmed(whole);
      if (line.empty()) continue;
      if (line.starts_with(header_.comment_sign()))
        header_.read_comment(line);
      else if (header_.is_read() && header_.is_other_comment(line))
        header_.keep_other_comment(line);
      else if (header_.is_read())
        read_line(has_empty_cells() ? whole : line);  // a tab at the end is an empty cell
      else if (!dialect_.is_separator_line(line))
        read_header(line);
    }
    if (!header_.is_read())
      throw InputError(table_.source + ": no header row (theta_i,phi_i,theta_o,phi_o,<channel>...)");
    if (table_.rows() == 0) throw InputError(table_.source + ": has no rows");
    finish();
    return header_.is_long() || mueller_ ? widened(table_, bands_) : std::move(table_);
  }

 private:
  const std::vector<Column>& columns() const { return header_.columns().columns; }

  // Returns whether empty cells denote directions that were not measured.
  bool has_empty_cells() const {
    return header_.matrix() || (header_.layout() && header_.layout()->is_fill("", std::nullopt));
  }

  [[noreturn]] void fail(const std::string& what) const { throw InputError(reader_.where() + ": " + what); }
  [[noreturn]] void fail(const Column& column, std::size_t k, const std::string& rule) const {
    fail("column " + std::to_string(k + 1) + " (" + printable(column.name) + "): " + shown(fields_[k]) + " " +
         rule);
  }

  void read_header(std::string_view line) {
    const bool is_row = header_.read(line);
    const std::size_t channels = header_.columns().channels.size();
    table_.values.resize(channels);
    table_.sigma.resize(channels);
    row_values_.resize(channels);
    row_sigma_.resize(channels);
    has_phase_ = header_.columns().has(Column::Kind::phase);
    for (const Column& c : columns()) has_sigma_ = has_sigma_ || c.kind == Column::Kind::sigma;
    mueller_ = supplied_.polarised ? header_.columns().mueller : std::nullopt;
    if (mueller_ && channels != 1)
      fail("polarised channels of a Mueller matrix need one column of its first element");
    set_constants();
    if (is_row) read_line(line);
  }

  // Sets the angles, the wavelength and the rotation that a layout states for all rows.
  void set_constants() {
    for (const auto& [column, number] : header_.columns().constants) {
      const double constant = column.converted(number);
      if (column.kind == Column::Kind::angle) angles_[column.index] = constant;
      if (column.kind == Column::Kind::wavelength) band_.nm = constant;
      if (column.kind == Column::Kind::rotation) turn_ = constant;
    }
    if (header_.layout() && header_.layout()->mirror_is_at_zero) light_turn_ = 180;
  }

  void read_line(std::string_view line) {
    split_row(line);
    if (header_.matrix())
      read_row_of_matrix(line);
    else
      read_row(line);
  }

  // Converts the numbers of the file to f_r, directions and bands.
  void finish() {
    make_f_r(table_, header_.columns().quantities);
    if (empty_ > 0)
      table_.warnings.push_back(std::to_string(empty_) +
                                " empty cells of the matrix are treated as not measured");
    table_.skipped += empty_;
    // Differences from the plain format come first among the warnings.
    std::vector<std::string> notes = header_.columns().notes;
    if (const std::string differences = dialect_.differences(); !differences.empty())
      notes.insert(notes.begin(), differences);
    table_.warnings.insert(table_.warnings.begin(), notes.begin(), notes.end());
    table_.assumptions = header_.columns().assumptions;
    add_facts();
    store_raw_angles();
    announce_small_angles();
    announce_summaries();
    if (header_.columns().in_plane)
      place_in_plane(table_, mirror_side());
    else
      refuse_mirror_side(table_.source, supplied_);
    find_unit_of_bands();
  }

  MirrorSide mirror_side() const {
    const std::optional<Layout>& layout = header_.layout();
    return layout && layout->mirror_side != MirrorSide::automatic ? layout->mirror_side
                                                                  : supplied_.mirror_side;
  }

  // Adds the facts of a layout that are not columns.
  void add_facts() {
    const std::optional<Layout>& layout = header_.layout();
    if (!layout) return;
    if (fill_rows_ > 0) {
      table_.warnings.push_back(plural(fill_rows_, "row") + " with a fill value of the layout left out");
      table_.skipped += fill_rows_;
    }
    if (!layout->aperture) return;
    const std::string width = to_text(*layout->aperture) + " degrees";
    table_.add_comment(kApertureKey, width);
    table_.warnings.push_back("the layout states a detector of " + width);
  }

  void store_raw_angles() {
    for (const Column& c : columns()) {
      if (c.kind != Column::Kind::angle) continue;
      RawAngle& angle = table_.raw_angles[c.index];
      angle.name = c.name;
      angle.has_unit = c.unit.has_value();
      std::move(raw_[c.index]).store(angle);
    }
  }

  // Reports polar angles that may be radians: no header gives a unit, all fit a quarter of a turn in radians,
  // and not all are whole numbers.
  void announce_small_angles() {
    constexpr double kMostRadians = 1.6;
    double largest = 0;
    bool is_fractional = false;
    for (const std::size_t a : {0, 2}) {
      const RawAngle& angle = table_.raw_angles[a];
      if (angle.name.empty()) continue;
      if (angle.has_unit) return;
      largest = std::max(largest, angle.largest);
      for (const double size : angle.magnitudes) is_fractional = is_fractional || size != std::floor(size);
    }
    if (!is_fractional || largest > kMostRadians) return;
    table_.assume(
        "the polar angles reach only " + short_number(largest, 6) +
        ", and the header gives no unit: read as degrees. Name the columns with their unit, such as "
        "'theta_i (rad)' if they are radians, or 'theta_i (deg)' if the sample was measured near the "
        "normal only");
  }

  // Finds the unit of wavelengths without a unit.
  void find_unit_of_bands() {
    const bool lacks_unit = std::any_of(columns().begin(), columns().end(), [](const Column& c) {
      return c.kind == Column::Kind::wavelength && !c.unit;
    });
    if (!lacks_unit) return;
    const auto largest = std::ranges::max_element(bands_);
    if (!are_micrometres(largest->nm)) {
      for (Band& band : bands_) band.nm = without_noise(band.nm);
      return;
    }
    const Unit micrometre = *unit_named("um");
    for (Band& band : bands_) band.nm = to_nm(band.nm, micrometre);
    table_.assume("the wavelengths have no unit and are all below 100: interpreted as micrometres");
  }

  void split_row(std::string_view line) {
    if (!dialect_.split_row(line, fields_)) fail(std::string(kBadQuotation));
  }

  void check_width(std::string_view line, std::size_t width) const {
    if (fields_.size() != width)
      fail(std::to_string(fields_.size()) + " columns, but the header has " + std::to_string(width) +
           ", separated by " + dialect_.separator_in_words() + other_separator(line, width));
  }

  // Returns a hint if the line has a different separator, otherwise an empty string.
  std::string other_separator(std::string_view line, std::size_t width) const {
    for (const auto& [c, words] : {std::pair(',', "','"), std::pair(';', "';'"), std::pair('\t', "a tab")})
      if (words != dialect_.separator_in_words() && fields_.size() == 1 &&
          static_cast<std::size_t>(std::ranges::count(line, c)) == width - 1)
        return std::string("; this line is separated by ") + words;
    return "";
  }

  double number_of(const Column& column, std::size_t k) {
    double number;
    if (!dialect_.parse(fields_[k], number))
      fail(column, k,
           dialect_.marks_are_mixed() ? "has a different decimal mark than the numbers before"
                                      : "is not a number" + advice_on(fields_[k]));
    if (column.kind == Column::Kind::angle) raw_[column.index].add(number);
    number = column.converted(number);
    if (!std::isfinite(number)) fail(column, k, "is not finite" + advice_on(fields_[k]));
    return number;
  }

  void read_row(std::string_view line) {
    const std::vector<Column>& all = columns();
    // Programs end each row with a separator, although the header row has none.
    if (fields_.size() == all.size() + 1 && fields_.back().empty() && !header_.layout()) fields_.pop_back();
    check_width(line, all.size());
    if (holds_fill()) {
      ++fill_rows_;
      return;
    }
    if (table_.rows() == 0) reserve(line.size() + 1);
    for (std::size_t k = 0; k < all.size(); ++k) {
      const Column& column = all[k];
      if (column.kind == Column::Kind::polarisation)
        read_polarisation(k);
      else if (column.kind != Column::Kind::aside)
        read_number(column, k, number_of(column, k));
    }
    note_summary(all);
    if (mueller_)
      store_polarised();
    else
      store_row();
  }

  // Counts the rows that seem to summarise others, by a word in a column that is not read.
  void note_summary(const std::vector<Column>& all) {
    ++measured_rows_;
    for (std::size_t k = 0; k < all.size(); ++k) {
      if (all[k].kind != Column::Kind::aside || !is_summary_word(fields_[k])) continue;
      if (summaries_++ == 0)
        first_summary_ = reader_.where() + ": column " + shown(all[k].name) + " holds " +
                         shown(std::string(trimmed(fields_[k])));
      return;
    }
  }

  // A table of which every row is a mean is a table of means.
  void announce_summaries() {
    if (summaries_ == 0 || summaries_ == measured_rows_) return;
    table_.assume(plural(summaries_, "row") + " with a word such as 'mean' or 'total' " +
                  (summaries_ == 1 ? "counts" : "count") + " as measured (" + first_summary_ +
                  "): remove them if they summarise other rows");
  }

  // Returns whether a value or an uncertainty of this row is a fill value.
  bool holds_fill() {
    const std::optional<Layout>& layout = header_.layout();
    if (!layout || (layout->fill_numbers.empty() && layout->fill_words.empty())) return false;
    for (std::size_t k = 0; k < columns().size(); ++k) {
      const Column::Kind kind = columns()[k].kind;
      if (kind != Column::Kind::value && kind != Column::Kind::sigma) continue;
      double number;
      const bool is_number = dialect_.parse(fields_[k], number);
      if (layout->is_fill(fields_[k], is_number ? std::optional(number) : std::nullopt)) return true;
    }
    return false;
  }

  // Converts relative uncertainties, for which the values of the row must be known.
  void complete_sigma() {
    for (const Column& c : columns())
      if (c.kind == Column::Kind::sigma && c.is_relative) {
        row_sigma_[c.index] *= std::abs(row_values_[c.index]);
        if (!(row_sigma_[c.index] > 0))
          fail("the relative uncertainty of the value 0 is 0, and must be above 0");
      }
  }

  // Stores a row for each polarisation of the light alone, and of light and viewer. The Stokes vectors of s
  // and p are (1, 1, 0, 0) and (1, -1, 0, 0).
  void store_polarised() {
    using Of = Polarisation;
    const double m11 = row_values_[0], scale = mueller_->is_divided ? m11 : 1;
    const auto element = [&](std::size_t k) { return scale * number_of(columns()[k], k); };
    const double m12 = element(mueller_->m12), m21 = element(mueller_->m21), m22 = element(mueller_->m22);
    constexpr double kRounding = 1.001;
    for (const double m : {m12, m21, m22})
      if (std::abs(m) > kRounding * std::abs(m11))
        fail("an element of the Mueller matrix exceeds the first one, " + to_text(m11));
    for (const auto& [polarisation, value] :
         {std::pair(Of::s, m11 + m12), std::pair(Of::p, m11 - m12),
          std::pair(Of::ss, (m11 + m12 + m21 + m22) / 2), std::pair(Of::sp, (m11 + m12 - m21 - m22) / 2),
          std::pair(Of::ps, (m11 - m12 + m21 - m22) / 2), std::pair(Of::pp, (m11 - m12 - m21 + m22) / 2)}) {
      row_values_[0] = value;
      band_.polarisation = polarisation;
      store_row();
    }
  }

  // Reserves memory for about as many rows as the file has, estimated from the length of the first row.
  void reserve(std::size_t bytes) {
    constexpr std::size_t kFewest = 8;  // bytes of a row
    const std::size_t rows = reader_.content().bytes.size() / std::max(bytes, kFewest) + 1;
    table_.reserve(std::min(rows, kMostRows));
    table_.lines.reserve(std::min(rows, kMostRows));
  }

  void read_row_of_matrix(std::string_view line) {
    const MatrixHeader& matrix = *header_.matrix();
    check_width(line, matrix.angles.size() + 1);
    static const Column value;
    constexpr double kRoadViewer = 89;  // degrees
    angles_[1] = 0;
    angles_[2] = matrix.is_road ? kRoadViewer : 0;
    angles_[3] = matrix.is_road ? 180 : 0;
    for (std::size_t k = 1; k < fields_.size(); ++k) {
      if (!advice_on(fields_[k]).empty() && fields_[k].find_first_of("0123456789") == fields_[k].npos) {
        ++empty_;
        continue;
      }
      set_angle(matrix.rows, 0, number_of(matrix.rows, 0));
      raw_[matrix.columns.index].add(matrix.angles[k - 1]);
      angles_[matrix.columns.index] = matrix.columns.converted(matrix.angles[k - 1]);
      row_values_[0] = number_of(value, k);
      if (is_fill_value(row_values_[0]))
        fail(value, k, "usually means 'not measured': leave such cells of a matrix empty");
      store_row();
    }
  }

  void set_angle(const Column& column, std::size_t k, double number) {
    largest_[column.index] = std::max(largest_[column.index], std::abs(number));
    if (column.index % 2 == 0 && std::abs(number) > 90.0) below_horizon(column, k);
    angles_[column.index] = number;
  }

  void read_number(const Column& column, std::size_t k, double number) {
    switch (column.kind) {
      case Column::Kind::angle:
        set_angle(column, k, number);
        break;
      case Column::Kind::value:
        row_values_[column.index] = number;
        break;
      case Column::Kind::sigma:
        if (!(number > 0.0)) fail(column, k, "must be above 0");
        row_sigma_[column.index] = number / column.coverage;
        break;
      case Column::Kind::wavelength:
        if (!(number > 0.0)) fail(column, k, "must be above 0");
        band_.nm = number;
        break;
      case Column::Kind::rotation:
        turn_ = number;
        break;
      case Column::Kind::phase:
        phase_ = number;
        break;
      case Column::Kind::polarisation:
      case Column::Kind::aside:
        break;
    }
  }

  void read_polarisation(std::size_t k) {
    band_.polarisation = polarisation_named(fields_[k]);
    if (!band_.polarisation) fail(columns()[k], k, "is not a polarisation (s, p, ss, sp, ps, pp, te, tm)");
  }

  // Throws for a polar angle above 90 degrees. Azimuths in the column of the polar angle are distinguished
  // from a wrong angle: there are many of them, and the other column never exceeds 90 degrees. Reads the
  // rest of the file to find this out.
  [[noreturn]] void below_horizon(const Column& column, std::size_t k) {
    const std::size_t theta = column.index, phi = theta + 1;
    const std::string at = reader_.where() + ": column " + std::to_string(k + 1) + " (" +
                           printable(column.name) + "): " + shown(fields_[k]) + " ";
    std::size_t rows = table_.rows(), above = 0;
    bool first = true;
    for (std::string_view line; first || reader_.next(line); first = false) {
      if (!first) split_row(trimmed(line));
      if (fields_.size() != columns().size()) continue;
      for (std::size_t field = 0; field < columns().size(); ++field) {
        const Column& c = columns()[field];
        double x;
        if (c.kind != Column::Kind::angle || !dialect_.parse(fields_[field], x)) continue;
        x = std::abs(c.converted(x));
        largest_[c.index] = std::max(largest_[c.index], x);
        above += c.index == theta && x > 90.0;
      }
      ++rows;
    }
    if (!header_.columns().in_plane && largest_[phi] <= 90.0 && above > 1 && 4 * above >= rows) {
      const std::string t(kAngleNames[theta]), p(kAngleNames[phi]);
      throw ExchangedColumns(at + "is below the horizon; " + t + " reaches " + to_text(largest_[theta]) +
                             " degrees and " + p + " only " + to_text(largest_[phi]) + ": the columns " + t +
                             " and " + p + " seem to be exchanged");
    }
    throw InputError(at + "is below the horizon (theta must be between -90 and 90 degrees)" +
                     (theta == 2 ? "; transmitted light is not read" : ""));
  }

  void store_row() {
    if (table_.rows() == kMostRows) fail("more than " + std::to_string(kMostRows) + " rows");
    double theta_i = angles_[0], phi_i = angles_[1] + light_turn_ - turn_, theta_o = angles_[2],
           phi_o = angles_[3] - turn_;
    if (has_phase_) phi_o = phi_i + azimuth_between(theta_i, theta_o);
    if (!header_.columns().in_plane) {
      // Instruments that swing through the normal write the far side as negative theta.
      unfold(theta_i, phi_i);
      unfold(theta_o, phi_o);
    }
    table_.add_directions(theta_i, phi_i, theta_o, phi_o);
    for (std::size_t c = 0; c < row_values_.size(); ++c) table_.values[c].push_back(row_values_[c]);
    if (has_sigma_) {
      complete_sigma();
      for (const Column& c : columns())
        if (c.kind == Column::Kind::sigma) table_.sigma[c.index].push_back(row_sigma_[c.index]);
    }
    table_.lines.push_back(static_cast<std::uint32_t>(reader_.line()));
    if (header_.is_long() || mueller_) bands_.push_back(band_);
  }

  double azimuth_between(double theta_i, double theta_o) const {
    if (theta_i < 0 || theta_o < 0) fail("polar angles must not be negative in a table with phase angles");
    const double azimuth = azimuth_of_phase(theta_i, theta_o, phase_);
    if (std::isnan(azimuth))
      fail("the phase angle " + to_text(phase_) + " is not possible: directions at " + to_text(theta_i) +
           " and " + to_text(theta_o) + " degrees enclose " + to_text(std::abs(theta_i - theta_o)) + " to " +
           to_text(theta_i + theta_o) + " degrees");
    return azimuth;
  }

  static void unfold(double& theta, double& phi) {
    if (theta >= 0.0) return;
    theta = -theta;
    phi = within_turn(phi + 180.0);
  }

  LineReader reader_;
  const Supplied& supplied_;
  SampleTable table_;
  Dialect dialect_;
  CsvHeader header_;
  std::vector<std::string_view> fields_;
  double angles_[4] = {}, largest_[4] = {};  // of this row; largest magnitudes in the file so far
  double turn_ = 0;                          // rotation of the sample
  double light_turn_ = 0;                    // added to phi_i
  double phase_ = 0;                         // angle between the directions of this row
  RawMagnitudes raw_[4];
  std::vector<double> row_values_, row_sigma_;
  std::size_t empty_ = 0;      // empty cells of a matrix
  std::size_t fill_rows_ = 0;  // rows with a fill value of the layout
  std::size_t measured_rows_ = 0, summaries_ = 0;
  std::string first_summary_;  // the place and the word of the first row that seems to summarise others
  bool has_sigma_ = false, has_phase_ = false;
  std::optional<MuellerColumns> mueller_;  // if polarised channels are requested
  Band band_;                              // of this row
  std::vector<Band> bands_;
};

}  // namespace

SampleTable read_csv(const Content& text, bool need_values, const Supplied& supplied) {
  return CsvReader(text, need_values, supplied).read();
}

}  // namespace brdf::io
