#include "io/column_names.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <span>

#include "brdf/angle.h"
#include "io/angle_names.h"
#include "io/channel_colours.h"
#include "io/error.h"
#include "io/table_rules.h"
#include "io/text.h"

namespace brdf::io {
namespace {

struct Parts {
  std::string_view name, unit;
};

// A name and its unit, which stands in brackets, behind a slash or a comma, or as the last word.
std::vector<Parts> ways_to_part(std::string_view name) {
  std::vector<Parts> ways{{name, ""}};
  if (!name.empty() && (name.back() == ')' || name.back() == ']')) {
    const std::size_t open = name.find_last_of("([");
    if (open != name.npos && open > 0)
      ways.push_back({trimmed(name.substr(0, open)), trimmed(name.substr(open + 1, name.size() - open - 2))});
  }
  if (const std::size_t at = name.find_last_of("/, _"); at != name.npos && at > 0 && at + 1 < name.size())
    ways.push_back({trimmed(name.substr(0, at)), trimmed(name.substr(at + 1))});
  return ways;
}

constexpr std::string_view kDegrees[] = {"deg", "degs", "degree", "degrees", "°", "º"};
constexpr std::string_view kRadians[] = {"rad", "rads", "radian", "radians"};
constexpr std::string_view kNanometres[] = {"nm", "nanometre", "nanometres", "nanometer", "nanometers"};
constexpr std::string_view kMicrometres[] = {"um",      "µm",         "μm",        "micron",
                                             "microns", "micrometre", "micrometer"};
constexpr std::string_view kPerSteradian[] = {"1/sr",   "sr^-1", "sr^{-1}", "sr-1",       "sr⁻¹",
                                              "sr**-1", "/sr",   "per sr",  "1/steradian"};

bool is_one_of(std::string_view word, std::span<const std::string_view> words) {
  return std::find(words.begin(), words.end(), lower_case(word)) != words.end();
}

bool is_wavelength(std::string_view bare, std::string_view unit) {
  const std::string key = plain_spelling(bare);
  return (key == "wavelength" || key == "wavelengths" || key == "lambda" || key == "wl") &&
         (unit.empty() || is_one_of(unit, kNanometres) || is_one_of(unit, kMicrometres));
}

// Turns a header's names into columns; remembers what has to be said.
class Reading {
 public:
  Reading(const std::vector<std::string_view>& names, const std::string& where)
      : names_(names), where_(where) {}

  Columns result() {
    // A table in the plain format has channels of any name: what is written must be read back as it was.
    is_plain_ = std::none_of(names_.begin(), names_.end(), is_wavelength_name) &&
                std::none_of(names_.begin(), names_.end(), is_polarisation_name) &&
                has_plain_angle_names(names_);
    for (const std::string_view name : names_) out_.columns.push_back(column_of(name));
    place_angles();
    place_values();
    if (!read_as_.empty()) out_.notes.push_back("read as: " + read_as_);
    if (out_.only_azimuth) note_the_only_azimuth();
    return std::move(out_);
  }

 private:
  [[noreturn]] void refuse(const std::string& what) const { throw InputError(where_ + ": " + what); }

  // Adds "'their name' our name" to what is announced, where the names differ.
  void announce(std::string_view theirs, const std::string& ours) {
    if (theirs == ours) return;
    if (!read_as_.empty()) read_as_ += ", ";
    read_as_ += shown(theirs) + " " + ours;
  }

  Column column_of(std::string_view name) {
    Column column;
    column.name = name;
    angles_.emplace_back();
    if (is_plain_ && !is_plain_angle_name(name)) return column;
    if (is_polarisation_name(name)) column.kind = Column::Kind::polarisation;
    for (const auto& [bare, unit] : ways_to_part(name))
      if (read_as_angle(column, bare, unit) || read_as_wavelength(column, bare, unit)) break;
    return column;
  }

  // Whether the name is an angle's, which the column then holds.
  bool read_as_angle(Column& column, std::string_view bare, std::string_view unit) {
    const std::optional<AngleName> angle = angle_named(bare);
    const bool is_radians = is_one_of(unit, kRadians);
    if (!angle || !(unit.empty() || is_radians || is_one_of(unit, kDegrees))) return false;
    angles_.back() = angle;
    column.kind = Column::Kind::angle;
    column.has_unit = !unit.empty();
    if (angle->quantity == AngleName::Quantity::elevation)
      column.unit = is_radians ? Column::Unit::elevation_in_radians : Column::Unit::elevation;
    else if (is_radians)
      column.unit = Column::Unit::radians;
    return true;
  }

  static bool read_as_wavelength(Column& column, std::string_view bare, std::string_view unit) {
    if (!is_wavelength(bare, unit)) return false;
    column.kind = Column::Kind::wavelength;
    if (is_one_of(unit, kMicrometres)) column.unit = Column::Unit::micrometres;
    return true;
  }

  // Whether a column is an azimuth, or else a polar angle or elevation, of this side.
  bool states(bool azimuth, AngleSide side) const {
    return std::any_of(angles_.begin(), angles_.end(), [&](const auto& angle) {
      return angle && is_azimuth(*angle) == azimuth && angle->side == side;
    });
  }

  static bool is_azimuth(const AngleName& angle) { return angle.quantity == AngleName::Quantity::azimuth; }

  // Whose angle it is; theta_s beside an incident direction is the scattered one's.
  AngleSide side_of(std::size_t k) {
    const AngleName& angle = *angles_[k];
    if (angle.side == AngleSide::none) alone_ = k;
    if (angle.side != AngleSide::scatter_or_source)
      return angle.side == AngleSide::light ? AngleSide::light : AngleSide::viewer;
    const bool light = states(is_azimuth(angle), AngleSide::light),
               viewer = states(is_azimuth(angle), AngleSide::viewer);
    if (light == viewer)
      refuse("column " + shown(names_[k]) + " may be the source's or the scattered direction: " +
             (light ? "both are stated" : "neither is stated beside it"));
    return light ? AngleSide::viewer : AngleSide::light;
  }

  // Gives each angle's column its index; what is ambiguous is decided by its neighbours.
  void place_angles() {
    std::map<std::size_t, std::string> taken;
    for (std::size_t k = 0; k < out_.columns.size(); ++k) {
      if (!angles_[k]) continue;
      Column& column = out_.columns[k];
      column.index = (side_of(k) == AngleSide::light ? 0 : 2) + (is_azimuth(*angles_[k]) ? 1 : 0);
      const auto [first, is_new] = taken.emplace(column.index, std::string(names_[k]));
      const std::string ours(kAngleNames[column.index]);
      if (!is_new)
        refuse("columns " + shown(first->second) + " and " + shown(names_[k]) + " are both " + ours);
      announce_angle(column, ours);
    }
    const bool of_light = out_.has_angle(1), of_viewer = out_.has_angle(3);
    if (of_light != of_viewer) out_.only_azimuth = of_light ? 1 : 3;
    if (alone_ && of_light && of_viewer)
      refuse("column " + shown(names_[*alone_]) + " does not say whose azimuth it is, and " +
             std::string(kAngleNames[1]) + " is stated beside it");
  }

  void announce_angle(const Column& column, const std::string& ours) {
    switch (column.unit) {
      case Column::Unit::radians:
        return announce(column.name, ours + " in radians");
      case Column::Unit::elevation:
        return announce(column.name, ours + " = 90 - elevation");
      case Column::Unit::elevation_in_radians:
        return announce(column.name, ours + " = 90 - elevation in radians");
      default:
        return announce(column.name, ours);
    }
  }

  void place_values() {
    std::vector<Column*> sigmas;
    Column* alone = nullptr;  // a column called `sigma`, or the like
    for (Column& column : out_.columns) {
      if (column.kind != Column::Kind::value) continue;
      const std::string name = without_unit(column.name);
      if (name.starts_with(kSigmaPrefix)) {
        column.kind = Column::Kind::sigma;
        sigmas.push_back(&column);
      } else if (!is_plain_ && !alone && is_a_sigma(plain_spelling(name))) {
        alone = &column;
      } else {
        add_channel(column, name);
      }
    }
    if (alone && out_.channels.size() == 1) {
      alone->kind = Column::Kind::sigma;
      announce(alone->name, std::string(kSigmaPrefix) + out_.channels[0]);
    } else if (alone) {
      add_channel(*alone, alone->name);
    }
    for (Column* column : sigmas) place_sigma(*column);
  }

  void add_channel(Column& column, const std::string& name) {
    column.index = out_.channels.size();
    out_.channels.push_back(with_band_unit(name));
    announce(column.name, out_.channels.back());
  }

  static bool is_a_sigma(const std::string& key) {
    return key == "sigma" || key == "std" || key == "stdev" || key == "stddev" || key == "sd" ||
           key == "uncertainty";
  }

  void place_sigma(Column& column) {
    const std::string name = without_unit(column.name);
    const auto found = std::find(out_.channels.begin(), out_.channels.end(),
                                 with_band_unit(name.substr(kSigmaPrefix.size())));
    if (found == out_.channels.end()) refuse("column " + shown(column.name) + " has no column of values");
    column.index = static_cast<std::size_t>(found - out_.channels.begin());
    announce(column.name, name);
  }

  // A value's name without its unit, which can only be 1/sr.
  std::string without_unit(std::string_view name) const {
    if (is_plain_) return std::string(name);
    for (const auto& [bare, unit] : ways_to_part(name)) {
      if (unit == "%" || lower_case(unit) == "percent")
        refuse("column " + shown(name) + " is in percent, of what is not said; f_r in 1/sr is read");
      if (is_one_of(unit, kPerSteradian)) return std::string(bare);
    }
    if (const std::size_t at = name.rfind("1/sr"); at != name.npos && at > 0 && at + 4 == name.size())
      return std::string(trimmed(name.substr(0, name.find_last_not_of(" _,", at - 1) + 1)));
    return std::string(name);
  }

  void note_the_only_azimuth() {
    const std::size_t stated = *out_.only_azimuth, other = 4 - stated;
    const auto column = std::find_if(out_.columns.begin(), out_.columns.end(), [&](const Column& c) {
      return c.kind == Column::Kind::angle && c.index == stated;
    });
    out_.notes.push_back("one azimuth, " + shown(column->name) + ": taken for " +
                         std::string(kAngleNames[stated]) + " with " + std::string(kAngleNames[other]) +
                         " 0, so that the mirror direction is at 180 degrees");
  }

  const std::vector<std::string_view>& names_;
  const std::string& where_;
  Columns out_;
  std::vector<std::optional<AngleName>> angles_;  // what each column's name says
  std::optional<std::size_t> alone_;              // the column of an azimuth that does not say whose it is
  std::string read_as_;
  bool is_plain_ = false;
};

// The number of degrees with the fewest digits that is this angle to its last bit: instruments write 30 degrees as
// 0.5235987755982988.
double shortest_degrees(double radian) {
  const double plain = radians(radian).degrees();
  for (double scale = 1; scale <= 1e12; scale *= 10) {
    const double shorter = std::round(plain * scale) / scale;
    const double back = degrees(shorter).radians();
    if (std::abs(back - radian) <= std::abs(std::nextafter(radian, 4.0) - radian)) return shorter;
  }
  return plain;
}

}  // namespace

double Column::converted(double value) const {
  switch (unit) {
    case Unit::as_is:
      return value;
    case Unit::radians:
      return shortest_degrees(value);
    case Unit::elevation:
      return 90 - value;
    case Unit::elevation_in_radians:
      return 90 - shortest_degrees(value);
    case Unit::micrometres:
      return std::round(1e6 * value) / 1e3;  // to a picometre: .6328 is 632.8 nm
  }
  return value;
}

bool is_wavelength_name(std::string_view name) {
  const std::vector<Parts> ways = ways_to_part(name);
  return std::any_of(ways.begin(), ways.end(), [](const Parts& p) { return is_wavelength(p.name, p.unit); });
}

bool is_unit(std::string_view field) {
  if (field.size() > 1 && (field.front() == '[' || field.front() == '('))
    field = trimmed(field.substr(1, field.size() - 2));
  return field.empty() || field == "-" || is_one_of(field, kDegrees) || is_one_of(field, kRadians) ||
         is_one_of(field, kNanometres) || is_one_of(field, kMicrometres) || is_one_of(field, kPerSteradian);
}

bool is_polarisation_name(std::string_view name) {
  const std::string key = plain_spelling(name);
  return key == "polarisation" || key == "polarization";
}

bool Columns::has_angle(std::size_t angle) const {
  return std::any_of(columns.begin(), columns.end(),
                     [&](const Column& c) { return c.kind == Column::Kind::angle && c.index == angle; });
}

bool Columns::has(Column::Kind kind) const {
  return std::any_of(columns.begin(), columns.end(), [&](const Column& c) { return c.kind == kind; });
}

Columns understand_columns(const std::vector<std::string_view>& names, const std::string& where) {
  return Reading(names, where).result();
}

}  // namespace brdf::io
