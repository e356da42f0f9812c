// Spectral text of the Cornell laboratory: a count n, n wavelengths, then records of four angles in radians
// and n values. Line breaks have no meaning, and comments run from # to the end of the line.
#include <cmath>
#include <numbers>
#include <set>

#include "io/columns/stated_quantity.h"
#include "io/files/content.h"
#include "io/files/error.h"
#include "io/files/numbers.h"
#include "io/files/text.h"
#include "io/samples/foreign_rows.h"
#include "io/samples/highlight.h"
#include "io/samples/set_points.h"

namespace brdf::io::cornell {
namespace {

constexpr double kRounding = 1e-5;  // of printed radians
constexpr std::size_t kMostComments = 50;

// Iterates over the words of a text without its comments.
class Words {
 public:
  explicit Words(const Content& text) : lines_(text) {}

  // Returns false at the end of the text.
  bool next(std::string_view& word) {
    while (next_ == words_.size()) {
      std::string_view line;
      if (!lines_.next(line)) return false;
      const std::size_t mark = line.find('#');
      if (mark != line.npos && comments_.size() < kMostComments)
        comments_.emplace_back(trimmed(line.substr(mark + 1)));
      split_blanks(line.substr(0, mark), words_);
      next_ = 0;
      widths_.insert(words_.size());
    }
    word = words_[next_++];
    return true;
  }
  // Returns the comments so far, at most kMostComments.
  const std::vector<std::string>& comments() const { return comments_; }
  // Returns whether all lines with numbers have the same number of words, at least three, as in a table.
  bool is_rectangular() const {
    std::set<std::size_t> widths = widths_;
    widths.erase(0);
    return widths.size() == 1 && *widths.begin() >= 3;
  }
  std::size_t line() const { return lines_.line(); }
  std::string where() const { return lines_.where(); }

 private:
  LineReader lines_;
  std::vector<std::string_view> words_;
  std::size_t next_ = 0;
  std::set<std::size_t> widths_;
  std::vector<std::string> comments_;
};

bool next_number(Words& words, double& number) {
  std::string_view word;
  return words.next(word) && parse_number(word, number) && std::isfinite(number);
}

// Returns the wavelengths in nm, or an empty list if the text does not begin with a count and wavelengths
// in order.
std::vector<double> wavelengths_of(Words& words) {
  constexpr double kShortest = 100, kLongest = 1e5;
  double count;
  if (!next_number(words, count) || !(count >= 1 && count <= double(kMostChannels)) ||
      count != std::floor(count))
    return {};
  std::vector<double> nm;
  for (double wavelength; nm.size() < static_cast<std::size_t>(count); nm.push_back(wavelength)) {
    if (!next_number(words, wavelength) || !(wavelength >= kShortest && wavelength <= kLongest)) return {};
    const bool is_ordered = nm.size() < 2 || (wavelength > nm.back()) == (nm[1] > nm[0]);
    if (!is_ordered || (!nm.empty() && wavelength == nm.back())) return {};
  }
  return nm;
}

bool are_radians(const double (&angles)[4]) {
  constexpr double kPolar = std::numbers::pi, kAzimuth = 2 * std::numbers::pi;
  return std::abs(angles[0]) <= kPolar + kRounding && std::abs(angles[1]) <= kAzimuth + kRounding &&
         std::abs(angles[2]) <= kPolar + kRounding && std::abs(angles[3]) <= kAzimuth + kRounding;
}

// Converts an azimuth. -pi and pi are one direction, which becomes 180 degrees.
double azimuth(double radians) {
  const double degrees = degrees_of_printed_radians(radians);
  return degrees == -180 ? 180 : degrees;
}

class Reader {
 public:
  explicit Reader(const Content& text) : words_(text) {
    table_.source = text.name;
    table_.format = "cornell";
  }

  SampleTable read() {
    const std::vector<double> nm = wavelengths_of(words_);
    std::vector<std::string> names;
    for (const double wavelength : nm) names.push_back(to_text(wavelength) + "nm");
    table_.set_channels(std::move(names));
    for (const std::string& comment : words_.comments())
      if (!comment.empty()) table_.add_comment("", comment);
    while (read_record()) {
    }
    rows_.finish();
    table_.warnings.push_back(
        "read as f_r in 1/sr, angles in radians, mirror direction at phi_s = phi_i + 180");
    const std::size_t values = table_.rows() * nm.size();
    if (zeros_ > 0)
      table_.warnings.push_back(std::to_string(zeros_) + " of " + plural(values, "value") +
                                (zeros_ == 1 ? " is" : " are") +
                                " exactly 0, probably noise that was cut off at 0: weak evidence");
    check_highlight(table_);
    return std::move(table_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { throw InputError(words_.where() + ": " + what); }

  // Reads a number. Returns false at the end of the text, which is allowed before a record only.
  bool number(double& value, std::size_t place) {
    std::string_view word;
    if (!words_.next(word)) {
      if (place == 0) return false;
      throw InputError(table_.source + ": ends within a record, after " + plural(place, "number") + " of " +
                       std::to_string(4 + table_.channels.size()) + " (four angles and " +
                       plural(table_.channels.size(), "value") + ")");
    }
    if (!parse_number(word, value) || !std::isfinite(value)) fail(shown(word) + " is not a finite number");
    return true;
  }

  bool read_record() {
    double angles[4];
    record_.resize(table_.channels.size());
    for (std::size_t k = 0; k < 4; ++k)
      if (!number(angles[k], k)) return false;
    const std::size_t line = words_.line();
    for (std::size_t c = 0; c < record_.size(); ++c) number(record_[c], 4 + c);
    if (!are_radians(angles))
      fail("the angles " + to_text(angles[0]) + ", " + to_text(angles[1]) + ", " + to_text(angles[2]) + ", " +
           to_text(angles[3]) +
           " of a record are not radians: a number is missing or added before, or the angles are degrees");
    if (!rows_.add(degrees_of_printed_radians(angles[0]), azimuth(angles[1]),
                   degrees_of_printed_radians(angles[2]), azimuth(angles[3])))
      return true;
    for (std::size_t c = 0; c < record_.size(); ++c) {
      table_.values[c].push_back(record_[c]);
      zeros_ += record_[c] == 0;
    }
    table_.lines.push_back(static_cast<std::uint32_t>(line));
    return true;
  }

  Words words_;
  SampleTable table_;
  ForeignRows rows_{table_};
  std::vector<double> record_;
  std::size_t zeros_ = 0;
};

}  // namespace

// Recognises a count and wavelengths in order, followed by numbers. With a single wavelength, the angles of
// the first records must be radians too. A rectangular table of numbers without a header row is left to the
// reader of CSV.
bool recognises(const Content& text) {
  constexpr std::size_t kRecords = 16;
  Words words(text);
  const std::size_t count = wavelengths_of(words).size();
  if (count == 0) return false;
  double angles[4];
  for (std::size_t record = 0; record < kRecords; ++record) {
    for (std::size_t k = 0; k < 4; ++k)
      if (!next_number(words, angles[k])) return record > 0 && !words.is_rectangular();
    if (count == 1 && !are_radians(angles)) return false;
    std::string_view value;
    for (std::size_t c = 0; c < count; ++c)
      if (!words.next(value)) return record > 0 || count > 1;
  }
  return !words.is_rectangular();
}

SampleTable read(const Content& text, const Supplied& supplied) {
  require_f_r(text.name, supplied);
  return Reader(text).read();
}

}  // namespace brdf::io::cornell
