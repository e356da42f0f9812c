#include "io/formats/optical_constants.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

#include "brdf/fresnel.h"
#include "io/colour/channel_colours.h"
#include "io/colour/spectrum.h"
#include "io/columns/column_names.h"
#include "io/columns/wavelengths.h"
#include "io/csv/dialect.h"
#include "io/files/error.h"
#include "io/files/numbers.h"
#include "io/files/text.h"

namespace brdf::io {
namespace {

enum class StatedUnit { unsaid, nanometres, micrometres };

StatedUnit unit_of(std::string_view name) {
  const std::string key = lower_case(name);
  for (const char* word : {"um", "µm", "μm", "micr"})
    if (key.find(word) != key.npos) return StatedUnit::micrometres;
  for (const char* word : {"nm", "nano"})
    if (key.find(word) != key.npos) return StatedUnit::nanometres;
  return StatedUnit::unsaid;
}

// One quantity of the file, n or k, with its own wavelengths.
struct IndexColumn {
  std::vector<double> wavelengths, values;
};

class Reader {
 public:
  Reader(const Content& content, std::string_view material)
      : reader_(content), name_(content.name), asked_(material) {}

  OpticalConstants read() {
    for (std::string_view line; reader_.next(line);) {
      line = trimmed(line);
      if (line.empty() || line.front() == '#') continue;
      is_record_ = is_record_ || (!wavelength_ && is_record_key(line));
      if (const std::size_t type = line.find("type:"); type != line.npos && type < 3)
        begin_record(trimmed(line.substr(type + 5)));
      else
        read_line(line);
    }
    return result();
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { throw InputError(reader_.where() + ": " + what); }
  [[noreturn]] void refuse(const std::string& what) const { throw InputError(name_ + ": " + what); }

  // Begins a part of a record of refractiveindex.info. Its wavelengths are in micrometres.
  void begin_record(std::string_view type) {
    is_record_ = true;
    wavelength_ = n_ = k_ = material_ = std::nullopt;
    unit_ = StatedUnit::micrometres;
    set_separator(' ');
    if (!type.starts_with("tabulated ")) {
      other_type_ = type;
      return;
    }
    std::size_t next = 0;
    wavelength_ = next++;
    if (type.find('n', 10) != type.npos) n_ = next++;
    if (type.find('k', 10) != type.npos) k_ = next++;
    width_ = next;
  }

  void read_line(std::string_view line) {
    if (is_record_) {
      if (is_numeric(line)) read_row(line);
    } else if (!wavelength_ || !is_a_row(line)) {
      read_header(line);
    } else {
      read_row(line);
    }
  }

  // Returns whether a line begins with a key of a record, such as `DATA:` or `REFERENCES: ...`.
  static bool is_record_key(std::string_view line) {
    const std::size_t colon = line.find(':');
    return colon != line.npos && colon > 0 && line.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ_") == colon;
  }

  static bool is_numeric(std::string_view line) {
    return line.find_first_not_of("0123456789+-.eE \t") == line.npos;
  }

  // Returns whether the field of the wavelength is a number. In a second header it is text.
  bool is_a_row(std::string_view line) {
    double number;
    split_line(line);
    return *wavelength_ >= fields_.size() || parse(fields_[*wavelength_], number);
  }

  void read_header(std::string_view line) {
    const std::size_t at = line.find_first_of("\t;,");
    set_separator(at == line.npos ? ' ' : line[at]);
    split_line(line);
    wavelength_ = n_ = k_ = material_ = std::nullopt;
    width_ = fields_.size();
    for (std::size_t c = 0; c < fields_.size(); ++c) {
      const std::string key = lower_case(fields_[c]);
      if (is_wavelength_name(fields_[c])) {
        wavelength_ = c;
        unit_ = unit_of(fields_[c]);
      }
      if (key == "n") n_ = c;
      if (key == "k" || key == "κ") k_ = c;
      if (key == "material") material_ = c;
    }
    if (!wavelength_ || (!n_ && !k_))
      fail(
          "is not a table of refractive indices (columns wavelength, n and k, or a record of "
          "refractiveindex.info); found " +
          shown(line));
  }

  void set_separator(char c) {
    dialect_ = Dialect();
    dialect_.is_separator_line(std::string("sep=") + c);
  }

  void split_line(std::string_view line) {
    if (!dialect_.split_row(line, fields_)) fail("a quotation mark is not closed, or text follows it");
  }

  bool parse(std::string_view field, double& value) {
    return dialect_.parse(field, value) && std::isfinite(value);
  }

  void read_row(std::string_view line) {
    if (!wavelength_) return;
    split_line(line);
    if (fields_.size() != width_)
      fail(std::to_string(fields_.size()) + " columns, but " + std::to_string(width_) + " are expected");
    if (material_) {
      const std::string found(fields_[*material_]);
      if (std::ranges::find(materials_, found) == materials_.end()) materials_.push_back(found);
      if (found != asked_) return;
    }
    constexpr double kShortest = 1e-3, kLongest = 1e9;  // in any unit: X rays to radio waves
    double nm;
    if (!parse(fields_[*wavelength_], nm) || !(nm >= kShortest && nm <= kLongest))
      fail(shown(fields_[*wavelength_]) + " is not a wavelength (0.001 to 1e9)");
    if (n_) add(read_n_, nm, *n_, "n");
    if (k_) add(read_k_, nm, *k_, "k");
  }

  void add(IndexColumn& column, double wavelength, std::size_t field, const char* what) {
    // Far above the index of any metal in the far infrared (some hundreds), and small enough to avoid
    // overflow.
    constexpr double kMostIndex = 1e6;
    double value;
    if (!parse(fields_[field], value) || value < 0 || value > kMostIndex)
      fail(std::string(what) + " " + shown(fields_[field]) + " must be a number from 0 to 1e6");
    column.wavelengths.push_back(wavelength);
    column.values.push_back(value);
  }

  OpticalConstants result() {
    if (!materials_.empty() && read_n_.values.empty())
      refuse((asked_.empty() ? "has several materials: give FILE:MATERIAL"
                             : "has no material " + shown(asked_)) +
             " (known: " + joined(materials_) + ")");
    if (materials_.empty() && !asked_.empty())
      refuse("has no column of materials that could contain " + shown(asked_));
    if (read_n_.values.empty() && !other_type_.empty())
      refuse("type " + shown(other_type_) + " is not read (known: tabulated nk, tabulated n)");
    if (read_n_.values.empty()) refuse("holds no row of wavelength and n");
    if (!read_k_.values.empty() && read_k_.wavelengths != read_n_.wavelengths)
      refuse("n and k are given at different wavelengths");
    return sorted();
  }

  OpticalConstants sorted() {
    const std::vector<double>& wavelengths = read_n_.wavelengths;
    const bool is_micrometres =
        unit_ == StatedUnit::micrometres ||
        (unit_ == StatedUnit::unsaid && are_micrometres(*std::ranges::max_element(wavelengths)));
    std::vector<std::pair<double, Index>> rows;
    for (std::size_t r = 0; r < wavelengths.size(); ++r)
      rows.push_back({is_micrometres ? std::round(1e7 * wavelengths[r]) / 1e4 : wavelengths[r],
                      {read_n_.values[r], read_k_.values.empty() ? 0.0 : read_k_.values[r]}});
    std::ranges::stable_sort(rows, [](const auto& a, const auto& b) { return a.first < b.first; });
    OpticalConstants out{name_ + (asked_.empty() ? "" : ":" + asked_), {}, {}};
    for (const auto& [nm, index] : rows) {
      if (!out.nm.empty() && nm == out.nm.back())
        refuse("the wavelength " + to_text(nm) + " nm is listed twice");
      out.nm.push_back(nm);
      out.index.push_back(index);
    }
    return out;
  }

  LineReader reader_;
  std::string name_, asked_, other_type_;
  std::vector<std::string> materials_;
  std::vector<std::string_view> fields_;
  std::optional<std::size_t> wavelength_, n_, k_, material_;  // indices of columns
  std::size_t width_ = 0;
  StatedUnit unit_ = StatedUnit::unsaid;
  Dialect dialect_;
  bool is_record_ = false;
  IndexColumn read_n_, read_k_;
};

double reflectance(const Index& index) {
  return fresnel_conductor(index.n, index.k, 1.0);
}

}  // namespace

Index OpticalConstants::at(double wavelength) const {
  if (!(wavelength >= nm.front() && wavelength <= nm.back()))
    throw InputError(source + ": " + to_text(wavelength) + " nm is outside the range of this file, " +
                     to_text(nm.front()) + " to " + to_text(nm.back()) + " nm");
  const std::size_t upper = std::size_t(std::lower_bound(nm.begin(), nm.end(), wavelength) - nm.begin());
  if (nm[upper] == wavelength) return index[upper];
  const Index &a = index[upper - 1], &b = index[upper];
  const double t = (wavelength - nm[upper - 1]) / (nm[upper] - nm[upper - 1]);
  return {a.n + t * (b.n - a.n), a.k + t * (b.k - a.k)};
}

std::vector<Index> OpticalConstants::indices(const std::vector<std::string>& channels) const {
  std::vector<Index> out;
  for (const std::string& channel : channels) {
    const std::optional<double> wavelength = wavelength_of(channel);
    if (!wavelength)
      throw InputError(source + ": channel " + shown(channel) +
                       " is not named by a wavelength (such as 465nm)");
    out.push_back(at(*wavelength));
  }
  return out;
}

std::vector<double> OpticalConstants::reflectances(const std::vector<std::string>& channels) const {
  std::vector<double> out;
  const std::optional<ChannelColours> colours = channel_colours(channels);
  if (channels.size() != 3 || !colours || colours->by != ChannelColours::By::name) {
    for (const Index& found : indices(channels)) out.push_back(reflectance(found));
    return out;
  }
  constexpr double kFirst = 380, kLast = 780, kStep = 5, kRed = 620, kBlue = 480;
  std::vector<double> wavelengths;
  for (double w = kFirst; w <= kLast; w += kStep)
    if (w >= nm.front() && w <= nm.back()) wavelengths.push_back(w);
  if (wavelengths.empty() || wavelengths.front() > kBlue || wavelengths.back() < kRed)
    throw InputError(source + ": does not cover 480 to 620 nm, which colours require");
  const std::vector<Tristimulus> weights = srgb_weights(wavelengths);
  Tristimulus sum{};
  for (std::size_t w = 0; w < wavelengths.size(); ++w)
    for (std::size_t c = 0; c < 3; ++c) sum[c] += weights[w][c] * reflectance(at(wavelengths[w]));
  out.resize(3);
  for (std::size_t c = 0; c < 3; ++c) out[colours->of[c]] = std::clamp(sum[c], 0.0, 1.0);
  return out;
}

OpticalConstants read_optical_constants(const Content& content, std::string_view material) {
  Content text = content;
  make_utf8(text);
  return Reader(text, material).read();
}

OpticalConstants read_optical_constants(const std::string& named) {
  const std::size_t colon = named.rfind(':');
  if (colon == named.npos || std::filesystem::exists(named))
    return read_optical_constants(read_content(named));
  return read_optical_constants(read_content(named.substr(0, colon)), named.substr(colon + 1));
}

}  // namespace brdf::io
