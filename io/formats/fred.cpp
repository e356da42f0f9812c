// FRED's tabulated BSDF: "type bsdf_data", a line "format", and blocks of rows. The head of a block is the
// mirror direction, in the frame of the scattering directions.
#include <cmath>
#include <optional>

#include "io/columns/stated_quantity.h"
#include "io/files/content.h"
#include "io/files/error.h"
#include "io/files/numbers.h"
#include "io/files/text.h"
#include "io/samples/foreign_rows.h"
#include "io/samples/highlight.h"
#include "io/samples/set_points.h"
#include "io/samples/to_f_r.h"

namespace brdf::io::fred {
namespace {

bool is_comment(std::string_view line) {
  return line.empty() || line.starts_with('#') || line.starts_with('!') || line.starts_with("//");
}

class Reader {
 public:
  explicit Reader(const Content& text) : lines_(text) {
    table_.source = text.name;
    table_.format = "fred";
    table_.set_channels({"fr"});
  }

  SampleTable read() {
    read_format();
    while (next_line()) {
      if (words_.size() == 2)
        begin_block();
      else if (words_.size() == 3)
        read_row();
      else
        fail(plural(words_.size(), "word") +
             ": expected are two angles of the mirror direction, or two angles and a value");
    }
    end_block();
    rows_.finish();
    make_f_r(table_, {Quantity{&quantity_kinds()[0], scale_}});
    table_.warnings.push_back("read as f_r in 1/sr" +
                              (scale_ == 1 ? "" : ", the values times scale=" + to_text(scale_)) +
                              "; the head of each block is the mirror direction, so the incident light is at "
                              "theta_spec, phi_spec + 180");
    if (empty_blocks_ > 0)
      table_.warnings.push_back(plural(empty_blocks_, "block") + " without values left out");
    check_highlight(table_);
    return std::move(table_);
  }

 private:
  struct Direction {
    double theta, phi;
  };

  [[noreturn]] void fail(const std::string& what) const { throw InputError(lines_.where() + ": " + what); }

  bool next_line() {
    for (std::string_view line; lines_.next(line);) {
      line = trimmed(line);
      if (is_comment(line)) continue;
      split_blanks(line, words_);
      return true;
    }
    return false;
  }

  void read_format() {
    if (!next_line() || words_.size() != 2 || lower_case(words_[1]) != "bsdf_data")
      fail("'type bsdf_data' expected");
    if (!next_line() || lower_case(words_[0]) != "format")
      fail("a line 'format angles=deg bsdf=value scale=1' expected");
    std::optional<bool> in_radians;
    bool has_values = false;
    for (std::size_t k = 1; k < words_.size(); ++k) {
      const std::string word = lower_case(words_[k]);
      if (word == "angles=deg" || word == "angles=rad")
        in_radians = word == "angles=rad";
      else if (word == "bsdf=value")
        has_values = true;
      else if (!word.starts_with("scale="))
        fail(shown(words_[k]) + " is not read (known: angles=deg, angles=rad, bsdf=value, scale=NUMBER)");
      else if (!parse_number(std::string_view(word).substr(6), scale_) || !std::isfinite(scale_) ||
               !(scale_ > 0))
        fail(shown(words_[k]) + ": the scale must be a number above 0");
    }
    if (!in_radians || !has_values)
      fail("the line 'format' must have angles=deg or angles=rad, and bsdf=value");
    in_radians_ = *in_radians;
  }

  double number(std::size_t column) const {
    double value;
    if (!parse_number(words_[column], value) || !std::isfinite(value))
      fail("column " + std::to_string(column + 1) + ": " + shown(words_[column]) + " is not a finite number");
    return value;
  }

  double angle(std::size_t column, double largest) const {
    const double given = number(column);
    const double degrees = in_radians_ ? degrees_of_printed_radians(given) : given;
    if (!(std::abs(degrees) <= largest))
      fail("column " + std::to_string(column + 1) + ": " + to_text(given) + " must be between -" +
           to_text(largest) + " and " + to_text(largest) + " degrees");
    return degrees;
  }

  Direction direction() const { return {angle(0, 180), angle(1, kLargestAzimuth / 2)}; }

  void begin_block() {
    end_block();
    mirror_ = direction();
    rows_of_block_ = 0;
  }

  void end_block() { empty_blocks_ += mirror_ && rows_of_block_ == 0; }

  void read_row() {
    if (!mirror_) fail("a row of three numbers has no block: a line of two angles must come first");
    ++rows_of_block_;
    const Direction scattered = direction();
    const double value = number(2);
    if (!rows_.add(mirror_->theta, mirror_->phi + 180, scattered.theta, scattered.phi)) return;
    table_.values[0].push_back(value);
    table_.lines.push_back(static_cast<std::uint32_t>(lines_.line()));
  }

  LineReader lines_;
  SampleTable table_;
  ForeignRows rows_{table_};
  std::vector<std::string_view> words_;
  std::optional<Direction> mirror_;
  double scale_ = 1;
  bool in_radians_ = false;
  std::size_t rows_of_block_ = 0, empty_blocks_ = 0;
};

}  // namespace

bool recognises(const Content& text) {
  LineReader reader(text);
  for (std::string_view line; reader.next(line);) {
    line = trimmed(line);
    if (is_comment(line)) continue;
    std::vector<std::string_view> words;
    split_blanks(line, words);
    return words.size() == 2 && lower_case(words[0]) == "type" && lower_case(words[1]) == "bsdf_data";
  }
  return false;
}

SampleTable read(const Content& text, const Supplied& supplied) {
  require_f_r(text.name, supplied);
  return Reader(text).read();
}

}  // namespace brdf::io::fred
