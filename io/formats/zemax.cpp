#include "io/formats/zemax.h"

#include <cmath>
#include <numbers>

#include "brdf/vec3.h"
#include "io/columns/stated_quantity.h"
#include "io/files/content.h"
#include "io/files/error.h"
#include "io/files/text.h"
#include "io/samples/degrees.h"
#include "io/samples/repetition.h"

namespace brdf::io::zemax {
namespace {

// Iterates over the lines of a file as words. Comments and blank lines are skipped.
class Lines {
 public:
  explicit Lines(const Content& text) : reader_(text), name_(text.name) {}

  bool next(std::vector<std::string_view>& words) {
    std::string_view line;
    while (reader_.next(line)) {
      line = trimmed(line);
      if (line.starts_with('#')) comment(trimmed(line.substr(1)));
      if (line.empty() || line.starts_with('#')) continue;
      split_blanks(line, words);
      return true;
    }
    return false;
  }
  void require(std::vector<std::string_view>& words, const std::string& what) {
    if (!next(words)) throw InputError(name_ + ": ends early, " + what + " is expected");
  }
  // Reads the line "KEY VALUE".
  std::string value_of(const std::string& key) {
    require(words_, key);
    if (words_.size() != 2 || words_[0] != key) fail("'" + key + " <value>' expected");
    return std::string(words_[1]);
  }
  std::vector<double> numbers(const std::string& what, std::size_t count) {
    require(words_, what);
    if (words_.size() != count)
      fail(std::to_string(words_.size()) + " numbers, but " + std::to_string(count) + " are expected (" +
           what + ")");
    std::vector<double> values(count);
    for (std::size_t k = 0; k < count; ++k)
      if (!parse_number(words_[k], values[k]) || !std::isfinite(values[k]))
        fail("column " + std::to_string(k + 1) + ": " + shown(words_[k]) + " is not a number");
    return values;
  }
  // Reads "KEY n" and the n numbers on the next line.
  std::vector<double> enumeration(const std::string& key) {
    const std::string text = value_of(key);
    double count;
    if (!parse_number(text, count) || !(count >= 1 && count <= 100000) || count != std::floor(count))
      fail(shown(text) + " is not a number of angles");
    const std::vector<double> angles = numbers("the angles of " + key, static_cast<std::size_t>(count));
    for (const double angle : angles)
      if (!(std::abs(angle) <= kLargestAzimuth))
        fail("angle " + to_text(angle) + " must be between -1e6 and 1e6 degrees");
    return angles;
  }
  [[noreturn]] void fail(const std::string& what) const { throw InputError(reader_.where() + ": " + what); }
  std::size_t line() const { return reader_.line(); }

  SampleTable table;  // holds the comments of the file

 private:
  void comment(std::string_view text) {
    const std::size_t colon = text.find(": ");
    if (colon != text.npos && colon < 40) table.add_comment(text.substr(0, colon), text.substr(colon + 1));
  }
  LineReader reader_;
  std::string name_;
  std::vector<std::string_view> words_;
};

struct Header {
  std::vector<double> rotation, theta_i, azimuth, radial;
  std::vector<std::string> channels;
};

Header read_header(Lines& lines) {
  Header header;
  lines.value_of("Source");
  lines.value_of("Symmetry");
  const std::string spectral = lines.value_of("SpectralContent");
  const std::string type = lines.value_of("ScatterType");
  if (type != "BRDF") lines.fail("ScatterType " + shown(type) + " is not read (only BRDF)");
  if (spectral == "Monochrome")
    header.channels = {"fr"};
  else if (spectral == "XYZ")
    header.channels = {"X", "Y", "Z"};
  else
    lines.fail("SpectralContent " + shown(spectral) + " is unknown (known: Monochrome, XYZ)");
  header.rotation = lines.enumeration("SampleRotation");
  header.theta_i = lines.enumeration("AngleOfIncidence");
  header.azimuth = lines.enumeration("ScatterAzimuth");
  header.radial = lines.enumeration("ScatterRadial");
  for (const double theta : header.theta_i)
    if (!(theta >= 0 && theta < 90))
      lines.fail("AngleOfIncidence " + to_text(theta) + " must be at least 0 and below 90");
  return header;
}

// Returns the direction at `radial` degrees from the mirror direction (theta_i, phi 0); z is the cosine of
// its polar angle.
Vec3<double> scattered(double theta_i, double azimuth, double radial) {
  const double st = sin_degrees(theta_i), ct = cos_degrees(theta_i);
  const Vec3<double> mirror{st, 0, ct}, to_normal{-ct, 0, st};  // the third axis is {0, -1, 0}
  const double sr = sin_degrees(radial), cr = cos_degrees(radial);
  const double c = cos_degrees(azimuth), s = sin_degrees(azimuth);
  return {cr * mirror.x + sr * c * to_normal.x, -sr * s, cr * mirror.z + sr * c * to_normal.z};
}

// Returns an angle as an instrument's set point, without the rounding errors of the rotation.
double set_point(double degrees) {
  constexpr double kPerDegree = 1e9;
  return std::round(degrees * kPerDegree) / kPerDegree + 0.0;  // + 0 turns -0 into 0
}

// Reads the values of one channel in file order.
void read_channel(Lines& lines, const Header& header, std::vector<double>& values,
                  std::vector<std::uint32_t>& at_line) {
  std::vector<std::string_view> words;
  lines.require(words, "the spectral content's name");
  lines.require(words, "DataBegin");
  if (words[0] != "DataBegin") lines.fail("'DataBegin' expected");
  for (std::size_t block = 0; block < header.rotation.size() * header.theta_i.size(); ++block) {
    lines.value_of("TIS");
    for (std::size_t a = 0; a < header.azimuth.size(); ++a) {
      for (const double value : lines.numbers("one value per radial angle", header.radial.size())) {
        if (values.size() == kMostRows) lines.fail("more than " + std::to_string(kMostRows) + " values");
        values.push_back(value);
        at_line.push_back(static_cast<std::uint32_t>(lines.line()));
      }
    }
  }
  lines.require(words, "DataEnd");
  if (words[0] != "DataEnd") lines.fail("'DataEnd' expected");
}

}  // namespace

bool recognises(const Content& text) {
  LineReader reader(text);
  std::string_view line;
  std::vector<std::string_view> words;
  while (reader.next(line)) {
    line = trimmed(line);
    if (line.empty() || line.starts_with('#')) continue;
    split_blanks(line, words);
    return words.size() == 2 && words[0] == "Source" && words[1] == "Measured";
  }
  return false;
}

SampleTable read(const Content& text, const Supplied& supplied) {
  require_f_r(text.name, supplied);
  Lines lines(text);
  const Header header = read_header(lines);
  std::vector<std::vector<double>> raw(header.channels.size());
  std::vector<std::uint32_t> at_line;
  for (auto& values : raw) {
    at_line.clear();
    read_channel(lines, header, values, at_line);
  }
  SampleTable table = std::move(lines.table);
  table.source = text.name;
  table.format = "zemax";
  table.set_channels(header.channels);
  std::size_t entry = 0, below = 0;
  for (const double rotation : header.rotation)
    for (const double theta_i : header.theta_i)
      for (const double azimuth : header.azimuth)
        for (const double radial : header.radial) {
          const std::size_t k = entry++;
          const Vec3<double> wo = scattered(theta_i, azimuth, radial);
          bool is_measured = wo.z > 0;
          below += !is_measured;
          for (const auto& values : raw) is_measured &= values[k] != 0;
          if (!is_measured) continue;
          const Polar viewer = polar_degrees(wo);
          const double theta_o = set_point(viewer.theta), phi_o = theta_o == 0 ? 0 : set_point(viewer.phi);
          table.add_directions(theta_i, 180 - rotation, theta_o, phi_o - rotation);
          for (std::size_t c = 0; c < raw.size(); ++c) table.values[c].push_back(raw[c][k]);
          table.lines.push_back(at_line[k]);
        }
  table.skipped = entry - table.rows();
  if (table.rows() == 0) throw InputError(table.source + ": holds no measured value");
  table.warnings.push_back(std::to_string(table.skipped) + " of " + std::to_string(entry) +
                           " entries left out: " + std::to_string(below) + " below the horizon, " +
                           std::to_string(table.skipped - below) + " zero (not measured)");
  // The mirror direction has one entry per azimuth, and azimuths 0 and 360 are the same direction.
  leave_out_repetitions(table, [](std::size_t, std::size_t) { return false; });
  return table;
}

}  // namespace brdf::io::zemax
