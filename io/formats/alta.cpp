#include "io/formats/alta.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "brdf/vec3.h"
#include "io/columns/stated_quantity.h"
#include "io/files/content.h"
#include "io/files/error.h"
#include "io/files/numbers.h"
#include "io/files/text.h"
#include "io/samples/degrees.h"
#include "io/samples/repetition.h"
#include "io/samples/to_f_r.h"

namespace brdf::io::alta {
namespace {

struct Pair {
  Vec3<double> light, viewer;
};

Vec3<double> towards(double theta, double phi) {
  return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

// ALTA's difference vector is the viewing direction, rotated so that the half vector becomes the normal.
Pair from_half(double theta_h, double phi_h, double theta_d, double phi_d) {
  const Vec3<double> d = towards(theta_d, phi_d), h = towards(theta_h, phi_h);
  const double x = std::cos(theta_h) * d.x + std::sin(theta_h) * d.z,
               z = std::cos(theta_h) * d.z - std::sin(theta_h) * d.x;
  const Vec3<double> viewer{std::cos(phi_h) * x - std::sin(phi_h) * d.y,
                            std::sin(phi_h) * x + std::cos(phi_h) * d.y, z};
  return {h * (2 * dot(viewer, h)) - viewer, viewer};
}

// The viewer's polar angle is the distance from the centre of a disc; the light is at azimuth 0.
Pair from_disc(double theta_light, double x, double y) {
  return {towards(theta_light, 0), towards(std::hypot(x, y), std::atan2(y, x))};
}

// Returns NaN components for a vector of length 0, which has no direction.
Vec3<double> unit(const Vec3<double>& v) {
  return v * (1 / std::hypot(v.x, v.y, v.z));
}

using Numbers = std::array<double, 6>;

// A parametrisation that gives both directions, under ALTA's name. Angles are in radians.
struct Parametrisation {
  std::string_view name;
  std::size_t dimensions;
  Pair (*directions)(const Numbers&);
};
constexpr Parametrisation kKnown[] = {
    {"SPHERICAL_TL_PL_TV_PV", 4,
     [](const Numbers& x) {
       return Pair{towards(x[0], x[1]), towards(x[2], x[3])};
     }},
    {"ISOTROPIC_TV_TL_DPHI", 3,
     [](const Numbers& x) {
       return Pair{towards(x[1], x[2]), towards(x[0], 0)};
     }},
    {"ISOTROPIC_TL_TV_PROJ_DPHI", 3, [](const Numbers& x) { return from_disc(x[0], x[1], x[2]); }},
    {"RUSIN_TH_PH_TD_PD", 4, [](const Numbers& x) { return from_half(x[0], x[1], x[2], x[3]); }},
    {"RUSIN_TH_TD_PD", 3, [](const Numbers& x) { return from_half(x[0], 0, x[1], x[2]); }},
    {"CARTESIAN", 6, [](const Numbers& x) {
       return Pair{unit({x[3], x[4], x[5]}), unit({x[0], x[1], x[2]})};
     }}};

class Reader {
 public:
  explicit Reader(const Content& text) : lines_(text) {
    table_.source = text.name;
    table_.format = "alta";
  }

  SampleTable read() {
    for (std::string_view line; lines_.next(line);) {
      line = trimmed(line);
      if (line.empty()) continue;
      if (line.starts_with('#'))
        read_header(line.substr(1));
      else
        read_row(line);
    }
    if (table_.rows() == 0) throw InputError(table_.source + ": holds no rows");
    if (table_.skipped > 0)
      table_.warnings.push_back(plural(table_.skipped, "row") +
                                " left out: a direction is below the horizon");
    if (segments_ > 0) table_.warnings.push_back("vertical segments are left out");
    const Quantity quantity = divides_ ? *quantity_named("f_r*cos_o") : Quantity{&quantity_kinds()[0]};
    make_f_r(table_, std::vector<Quantity>(table_.channels.size(), quantity));
    if (divides_) table_.warnings.push_back("the values were divided by the cosine of the viewing direction");
    leave_out_repetitions(table_, [&](std::size_t a, std::size_t b) { return places_[a] == places_[b]; });
    return std::move(table_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { throw InputError(lines_.where() + ": " + what); }

  void read_header(std::string_view text) {
    if (text.empty() || text.front() == ' ') return;  // a comment, or the end of a header
    split_blanks(text, words_);
    const std::string_view key = words_[0];
    const std::string_view value = trimmed(text.substr(key.size()));
    if (key == "DIM")
      read_dimensions();
    else if (key == "PARAM_IN")
      read_parametrisation(value);
    else if (key == "PARAM_OUT")
      read_quantity(value);
    else if (key == "VS")
      segments_ += std::size_t(std::count(words_.begin() + 1, words_.end(), "1") +
                               2 * std::count(words_.begin() + 1, words_.end(), "2"));
    else if (key == "FORMAT" || key == "BEGIN_STREAM")
      fail("binary tables of ALTA are not read, only text");
    else if (!value.empty())
      table_.add_comment(key, value);
  }

  void read_dimensions() {
    if (dimensions_ > 0) fail("#DIM is given twice");
    double in = 0, out = 0;
    if (words_.size() != 3 || !parse_number(words_[1], in) || !parse_number(words_[2], out) ||
        !(in >= 1 && in <= 6) || !(out >= 1 && out <= double(kMostChannels)) || in != std::floor(in) ||
        out != std::floor(out))
      fail("'#DIM <angles> <channels>' expected");
    dimensions_ = std::size_t(in);
    const auto channels = std::size_t(out);
    std::vector<std::string> names;
    for (std::size_t c = 0; c < channels; ++c)
      names.push_back(channels == 3   ? std::string(1, "rgb"[c])
                      : channels == 1 ? "f"
                                      : "f" + std::to_string(c + 1));
    table_.set_channels(std::move(names));
  }

  void read_parametrisation(std::string_view name) {
    parametrisation_ = std::ranges::find(kKnown, name, &Parametrisation::name);
    if (parametrisation_ != std::end(kKnown)) return;
    std::string known;
    for (const Parametrisation& p : kKnown) known += (known.empty() ? "" : ", ") + std::string(p.name);
    fail("#PARAM_IN " + shown(name) + " does not give both directions, or is unknown (known: " + known + ")");
  }

  void read_quantity(std::string_view name) {
    divides_ = name == "INV_STERADIAN_COSINE_FACTOR";
    if (!divides_ && name != "INV_STERADIAN" && name != "RGB_COLOR")
      fail("#PARAM_OUT " + shown(name) +
           " is not f_r (known: INV_STERADIAN, INV_STERADIAN_COSINE_FACTOR, RGB_COLOR)");
  }

  void check_header() const {
    if (!parametrisation_ || dimensions_ == 0) fail("the header lacks #DIM or #PARAM_IN");
    if (parametrisation_->dimensions != dimensions_)
      fail("#DIM has " + std::to_string(dimensions_) + " angles, but " + std::string(parametrisation_->name) +
           " has " + std::to_string(parametrisation_->dimensions));
  }

  double number(std::size_t column) const {
    double value;
    if (!parse_number(words_[column], value) || !std::isfinite(value))
      fail("column " + std::to_string(column + 1) + ": " + shown(words_[column]) + " is not a finite number");
    return value;
  }

  void read_row(std::string_view line) {
    check_header();
    split_blanks(line, words_);
    const std::size_t needed = dimensions_ + table_.channels.size();
    if (words_.size() != needed && words_.size() != needed + segments_)
      fail(std::to_string(words_.size()) + " columns, but #DIM requires " + std::to_string(needed));
    Numbers place{};
    for (std::size_t k = 0; k < dimensions_; ++k) place[k] = number(k);
    const Pair pair = parametrisation_->directions(place);
    constexpr double kGrazing = -1e-6;  // tolerance for a horizon that was printed with few digits
    const Polar light = polar_degrees(pair.light), viewer = polar_degrees(pair.viewer);
    if (!(pair.light.z > kGrazing && pair.viewer.z > kGrazing) ||
        (divides_ && !(cos_degrees(viewer.theta) > 0))) {
      ++table_.skipped;
      return;
    }
    if (table_.rows() == kMostRows) fail("more than " + std::to_string(kMostRows) + " rows");
    table_.add_directions(std::min(light.theta, 90.0), light.phi, std::min(viewer.theta, 90.0), viewer.phi);
    for (std::size_t c = 0; c < table_.channels.size(); ++c)
      table_.values[c].push_back(number(dimensions_ + c));
    table_.lines.push_back(static_cast<std::uint32_t>(lines_.line()));
    places_.push_back(place);
  }

  LineReader lines_;
  SampleTable table_;
  std::vector<Numbers> places_;  // [row], as written in the file
  std::vector<std::string_view> words_;
  std::size_t dimensions_ = 0, segments_ = 0;  // numbers of columns
  const Parametrisation* parametrisation_ = nullptr;
  bool divides_ = false;
};

}  // namespace

bool recognises(const Content& text) {
  LineReader reader(text);
  bool has_dimensions = false, has_parametrisation = false;
  for (std::string_view line; !(has_dimensions && has_parametrisation) && reader.next(line);) {
    line = trimmed(line);
    if (!line.empty() && !line.starts_with('#')) break;
    has_dimensions = has_dimensions || line.starts_with("#DIM ");
    has_parametrisation = has_parametrisation || line.starts_with("#PARAM_IN ");
  }
  return has_dimensions && has_parametrisation;
}

SampleTable read(const Content& text, const Supplied& supplied) {
  require_f_r(text.name, supplied);
  return Reader(text).read();
}

}  // namespace brdf::io::alta
