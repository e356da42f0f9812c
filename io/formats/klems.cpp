// Matrices of LBNL Window and Radiance as XML: means of f_r over patches of both hemispheres (Klems bases).
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "brdf/scalar.h"
#include "io/columns/stated_quantity.h"
#include "io/files/error.h"
#include "io/files/numbers.h"
#include "io/files/text.h"
#include "io/files/xml.h"
#include "io/formats/klems_bases.h"
#include "io/samples/aperture.h"
#include "io/samples/highlight.h"

namespace brdf::io::klems {
namespace {

using Rings = std::vector<Ring>;

struct Matrix {
  std::string wavelength, unit, direction, columns, rows;
  std::vector<double> values;
  std::string fault;  // the reason against the numbers
  std::size_t line = 0;

  bool is_reflection() const { return lower_case(direction).find("reflection") != std::string::npos; }
  bool is_front() const { return lower_case(direction).find("front") != std::string::npos; }
  // Returns the wavelength in nm, or std::nullopt for names of weighted spectra.
  std::optional<double> nm() const {
    double number;
    if (!parse_number(wavelength, number) || !(number > 0)) return std::nullopt;
    const std::string lower = lower_case(unit);
    const bool is_short = number < 100 && !lower.starts_with("nano");
    return is_short || lower.starts_with("micro") || lower == "um" ? number * 1000 : number;
  }
  std::string band() const {
    const std::optional<double> number = nm();
    return number ? to_text(*number) + "nm" : printable(wavelength, 60);
  }
  // "Reflection Front Visible", "Reflection Back 550nm"
  std::string name() const { return direction + " " + band(); }
  // Returns whether the name has each of these words, in any case.
  bool has(const std::vector<std::string_view>& words) const {
    const std::string own = lower_case(name());
    return std::ranges::all_of(words, [&](std::string_view word) { return own.find(word) != own.npos; });
  }
};

class Reader {
 public:
  Reader(const Content& text, const std::string& matrix) : text_(text), asked_(lower_case(matrix)) {
    table_.source = text.name;
    table_.format = "klems";
  }

  SampleTable read() {
    read_xml(
        text_, [&](std::string_view name) { begin(name); }, [&](const XmlElement& element) { end(element); });
    if (structure_.empty())
      table_.assume(
          "the file does not state IncidentDataStructure: columns are taken as incident directions");
    const std::vector<const Matrix*> chosen = chosen_matrices();
    take(chosen);
    describe(*chosen.front());
    check_highlight(table_);
    return std::move(table_);
  }

 private:
  [[noreturn]] void fail(std::size_t line, const std::string& what) const {
    throw InputError(text_.name + ", line " + std::to_string(line) + ": " + what);
  }

  void begin(std::string_view name) {
    if (name == "Layer") ++layers_;
    if (name == "AngleBasis") bases_.push_back({"", {}});
    if (name == "AngleBasisBlock") ring_ = {-1, -1, 0};
    if (name == "WavelengthData") wavelength_ = {"", ""};
    if (name == "WavelengthDataBlock") matrix_ = {};
  }

  void end(const XmlElement& e) {
    if (layers_ > 1) return;
    if (e.name == "IncidentDataStructure")
      structure_ = e.text;
    else if (e.name == "AngleBasisName" && !bases_.empty())
      bases_.back().first = e.text;
    else if (e.name == "LowerTheta")
      ring_.lower = number(e);
    else if (e.name == "UpperTheta")
      ring_.upper = number(e);
    else if (e.name == "nPhis")
      ring_.patches = count(e);
    else if (e.name == "AngleBasisBlock" && !bases_.empty())
      add_ring(e);
    else if (e.name == "Wavelength")
      wavelength_ = {e.text, std::string(e.attribute("unit"))};
    else
      end_of_matrix(e);
  }

  void end_of_matrix(const XmlElement& e) {
    if (e.name == "WavelengthDataDirection") matrix_.direction = e.text;
    if (e.name == "ColumnAngleBasis") matrix_.columns = e.text;
    if (e.name == "RowAngleBasis") matrix_.rows = e.text;
    if (e.name == "ScatteringData") read_numbers(e);
    if (e.name == "Name" || e.name == "Manufacturer" || e.name == "DeviceType")
      if (!e.text.empty()) table_.add_comment(lower_case(e.name), printable(e.text, 500));
    if (e.name == "WavelengthDataBlock") of_wavelength_.push_back(std::exchange(matrix_, {}));
    if (e.name != "WavelengthData") return;
    for (Matrix& matrix : of_wavelength_) {
      matrix.wavelength = wavelength_.first;
      matrix.unit = wavelength_.second;
      if (!matrix.is_reflection()) {
        ++transmissions_;
        continue;
      }
      kept_ += matrix.values.size();
      constexpr std::size_t kMostKept = 50'000'000;
      if (kept_ > kMostKept) fail(e.line, "more than " + std::to_string(kMostKept) + " values");
      matrices_.push_back(std::move(matrix));
    }
    of_wavelength_.clear();
  }

  double number(const XmlElement& e) const {
    double value;
    if (!parse_number(e.text, value) || !std::isfinite(value))
      fail(e.line, shown(e.text) + " is not a number (" + e.name + ")");
    return value;
  }

  std::size_t count(const XmlElement& e) const {
    constexpr double kMostPhis = 1000;
    const double value = number(e);
    if (!(value >= 1 && value <= kMostPhis) || value != std::floor(value))
      fail(e.line, e.name + " " + shown(e.text) + " must be a whole number from 1 to 1000");
    return static_cast<std::size_t>(value);
  }

  void add_ring(const XmlElement& e) {
    Rings& basis = bases_.back().second;
    const double before = basis.empty() ? 0 : basis.back().upper;
    if (ring_.patches == 0 || !(ring_.lower >= 0 && ring_.upper > ring_.lower && ring_.upper <= 90))
      fail(e.line, "an AngleBasisBlock needs nPhis and ThetaBounds with 0 <= LowerTheta < UpperTheta <= 90");
    if (std::abs(ring_.lower - before) > 1e-6)
      fail(e.line, "LowerTheta " + to_text(ring_.lower) + " must be " + to_text(before) +
                       ", the upper bound of the block before");
    constexpr std::size_t kMostRings = 1000;
    if (basis.size() == kMostRings) fail(e.line, "a basis has more than 1000 blocks");
    basis.push_back(ring_);
  }

  // Reads numbers between commas, semicolons or blanks. A fault matters only if the matrix is used.
  void read_numbers(const XmlElement& e) {
    constexpr std::string_view kBetween = " \t\r\n,;";
    matrix_.line = e.line;
    const std::string_view text = e.text;
    for (std::size_t at = text.find_first_not_of(kBetween); at != text.npos;
         at = text.find_first_not_of(kBetween, at)) {
      const std::size_t stop = std::min(text.find_first_of(kBetween, at), text.size());
      const std::string_view word = text.substr(at, stop - at);
      at = stop;
      double value;
      if (!parse_number(word, value) || !std::isfinite(value)) {
        matrix_.fault = shown(word) + " is not a finite number";
        return;
      }
      if (matrix_.values.size() == kMostRows) {
        matrix_.fault = "more than " + std::to_string(kMostRows) + " values";
        return;
      }
      matrix_.values.push_back(value);
    }
  }

  Rings basis_named(const std::string& name, std::size_t line) const {
    for (const auto& [known, rings] : bases_)
      if (known == name && !rings.empty()) return rings;
    std::string names;
    for (const Basis& basis : known_bases()) {
      if (lower_case(name) == lower_case(basis.name)) return basis.rings;
      names += (names.empty() ? "" : ", ") + basis.name;
    }
    fail(line, "the basis " + shown(name) + " is not defined in the file (known: " + names + ")");
  }

  // Returns the matrices that become the channels: of one surface, Visible before all other wavelengths.
  std::vector<const Matrix*> chosen_matrices() const {
    if (matrices_.empty())
      throw InputError(text_.name + ": holds no reflection (" + plural(transmissions_, "block") +
                       " of transmission, which is not read): export the reflection of the surface");
    std::vector<std::string_view> words;
    split_blanks(asked_, words);
    std::vector<const Matrix*> suitable;
    for (const Matrix& matrix : matrices_)
      if (matrix.has(words)) suitable.push_back(&matrix);
    if (suitable.empty())
      throw InputError(text_.name + ": --matrix " + shown(asked_) +
                       ": no matrix has this name (known: " + names_of_matrices(nullptr) + ")");
    const bool has_front = std::ranges::any_of(suitable, &Matrix::is_front);
    std::vector<const Matrix*> of_surface, visible, numbered;
    for (const Matrix* matrix : suitable) {
      if (matrix->is_front() != has_front) continue;
      of_surface.push_back(matrix);
      if (lower_case(matrix->wavelength) == "visible") visible.push_back(matrix);
      if (matrix->nm()) numbered.push_back(matrix);
    }
    if (!visible.empty()) return {visible.front()};
    if (numbered.size() == of_surface.size()) return numbered;
    return {of_surface.front()};
  }

  // Returns the names of the matrices, without those that are read together with `chosen`.
  std::string names_of_matrices(const Matrix* chosen) const {
    std::vector<std::string> names;
    for (const Matrix& matrix : matrices_) {
      const bool is_read = chosen && matrix.direction == chosen->direction &&
                           std::ranges::find(table_.channels, matrix.band()) != table_.channels.end();
      if (!is_read) names.push_back(matrix.name());
    }
    return joined(names);
  }

  void take(const std::vector<const Matrix*>& chosen) {
    const bool is_by_rows = lower_case(structure_) == "rows";
    if (!is_by_rows && !structure_.empty() && lower_case(structure_) != "columns")
      throw InputError(text_.name + ": IncidentDataStructure " + shown(structure_) +
                       " is not read (known: Columns, Rows)");
    for (const Matrix* matrix : chosen) {
      if (matrix->columns != chosen[0]->columns || matrix->rows != chosen[0]->rows)
        fail(matrix->line, "the basis differs between wavelengths");
      add_channel(*matrix, is_by_rows);
    }
  }

  void add_channel(const Matrix& matrix, bool is_by_rows) {
    const Rings columns = basis_named(matrix.columns, matrix.line),
                rows = basis_named(matrix.rows, matrix.line);
    incident_ = patches_of(is_by_rows ? rows : columns);
    outgoing_ = patches_of(is_by_rows ? columns : rows);
    const std::size_t size = incident_.size() * outgoing_.size();
    if (!matrix.fault.empty()) fail(matrix.line, matrix.direction + ": " + matrix.fault);
    if (size > kMostRows || matrix.values.size() != size)
      fail(matrix.line, matrix.direction + ": " + plural(matrix.values.size(), "value") + ", but " +
                            std::to_string(outgoing_.size()) + " x " + std::to_string(incident_.size()) +
                            " patches need " + std::to_string(size));
    table_.channels.push_back(matrix.band());
    if (table_.channels.back().empty()) table_.channels.back() = "fr";
    std::vector<double>& values = table_.values.emplace_back();
    table_.sigma.emplace_back();
    for (std::size_t i = 0; i < incident_.size(); ++i)
      for (std::size_t o = 0; o < outgoing_.size(); ++o) {
        if (table_.values.size() == 1)
          table_.add_directions(incident_[i].theta, std::fmod(incident_[i].phi + 180, 360),
                                outgoing_[o].theta, outgoing_[o].phi);
        values.push_back(matrix.values[is_by_rows ? i * outgoing_.size() + o : o * incident_.size() + i]);
      }
  }

  // Returns the largest reflectance over the incident patches. `is_exchanged`: of the transposed matrix.
  double largest_reflectance(bool is_exchanged) const {
    const std::vector<Patch>& patches = is_exchanged ? incident_ : outgoing_;
    const std::size_t n = is_exchanged ? outgoing_.size() : incident_.size();
    double largest = 0;
    for (std::size_t k = 0; k < n; ++k) {
      double sum = 0;
      for (std::size_t j = 0; j < patches.size(); ++j)
        sum += patches[j].projected *
               table_.values[0][is_exchanged ? j * outgoing_.size() + k : k * outgoing_.size() + j];
      largest = std::max(largest, sum);
    }
    return largest;
  }

  void describe(const Matrix& matrix) {
    const std::string others = names_of_matrices(&matrix);
    table_.assume("the matrix " + shown(matrix.direction) + ", " + joined(table_.channels) + ", is read" +
                  (others.empty()
                       ? ""
                       : "; not read: " + printable(others, 200) +
                             " (brdf convert FILE OUT.csv --matrix 'back visible' reads another)"));
    table_.warnings.push_back("read as f_r in 1/sr, the mirror direction of a patch is on the diagonal");
    if (transmissions_ > 0)
      table_.warnings.push_back(plural(transmissions_, "block") + " of transmission left out");
    if (layers_ > 1) table_.assume("only the first of " + plural(layers_, "layer") + " is read");
    const double solid_angle = 2 * kPi / static_cast<double>(outgoing_.size());
    const std::string width = short_number(aperture_of_solid_angle(solid_angle), 3);
    table_.add_comment(kApertureKey, width + " degrees");
    table_.warnings.push_back("the values are means over " + std::to_string(outgoing_.size()) +
                              " patches of about " + width +
                              " degrees: a narrower highlight is smeared over its patch");
    constexpr double kRounding = 1.01;
    const double reflectance = largest_reflectance(false);
    if (reflectance > kRounding)
      table_.assume("the matrix reflects up to " + short_number(reflectance, 3) + " of the incident light" +
                    (largest_reflectance(true) <= kRounding
                         ? ", but its transposed matrix at most 1: IncidentDataStructure may be wrong"
                         : ""));
  }

  const Content& text_;
  const std::string asked_;  // words of the matrix to read; empty: the usual one
  SampleTable table_;
  std::string structure_;
  std::vector<std::pair<std::string, Rings>> bases_;
  Ring ring_{-1, -1, 0};
  std::pair<std::string, std::string> wavelength_;  // text and unit
  Matrix matrix_;
  std::vector<Matrix> of_wavelength_, matrices_;
  std::vector<Patch> incident_, outgoing_;
  std::size_t layers_ = 0, transmissions_ = 0, kept_ = 0;
};

}  // namespace

bool recognises(const Content& text) {
  const std::size_t first = text.bytes.find_first_not_of(" \t\r\n");
  return first != text.bytes.npos && text.bytes[first] == '<' && xml_root(text.bytes) == "WindowElement";
}

SampleTable read(const Content& text, const Supplied& supplied) {
  require_f_r(text.name, supplied);
  return Reader(text, supplied.matrix).read();
}

}  // namespace brdf::io::klems
