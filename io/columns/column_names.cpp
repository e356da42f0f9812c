#include "io/columns/column_names.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "brdf/angle.h"
#include "io/columns/angle_names.h"
#include "io/columns/metadata_names.h"
#include "io/columns/plain_names.h"
#include "io/columns/polarisation_names.h"
#include "io/columns/stated_angles.h"
#include "io/columns/value_columns.h"
#include "io/columns/wavelengths.h"
#include "io/files/error.h"
#include "io/files/text.h"

namespace brdf::io {
namespace {

bool is_angle_unit(std::string_view text) {
  const auto unit = unit_named(text);
  return unit && unit->kind() == Unit::Kind::angle;
}

// Converts a header's names to columns and collects the notes for the user.
class HeaderReading {
 public:
  HeaderReading(const std::vector<std::string_view>& names, const HeaderFacts& facts)
      : names_(names), facts_(facts) {
    facts_.is_plain = has_plain_angle_names(names_);
    // A table that this program wrote must be read back unchanged.
    const auto& stated = facts_.stated;
    facts_.keeps_names =
        facts_.is_plain && stated && stated->by == StatedQuantity::By::comment && stated->quantity.is_f_r();
  }

  Columns result() {
    for (const std::string_view name : names_) out_.columns.push_back(column_of(name));
    if (!place_road()) place_angles();
    announce_bands_and_turns();
    if ((out_.has_angle(0) && out_.has_angle(2)) || facts_.doubts)
      place_values(out_, facts_,
                   [this](std::string_view theirs, const std::string& ours) { announce(theirs, ours); });
    if (!read_as_.empty()) out_.notes.insert(out_.notes.begin(), "read as: " + read_as_);
    if (out_.only_azimuth) note_the_only_azimuth();
    return std::move(out_);
  }

 private:
  // Refuses the table, or notes the doubt if the caller collects doubts.
  void refuse(std::size_t column, ColumnDoubt::Of of, const std::string& what) const {
    if (!facts_.doubts) throw InputError(facts_.where + ": " + what);
    facts_.doubts->push_back({of, column, what});
  }

  // Adds "'their name' our name" to the notes if the two names differ.
  void announce(std::string_view theirs, const std::string& ours) {
    if (theirs == ours) return;
    if (!read_as_.empty()) read_as_ += ", ";
    read_as_ += shown(theirs) + " " + ours;
  }

  Column column_of(std::string_view name) {
    Column column;
    column.name = name;
    angles_.emplace_back();
    if (is_polarisation_name(name)) column.kind = Column::Kind::polarisation;
    if (read_as_wavelength(column) || (facts_.keeps_names && !is_plain_angle_name(name))) return column;
    for (const auto& [bare, unit] : ways_to_part(name))
      if (read_as_angle(column, bare, unit) || read_as_rotation(column, bare, unit)) break;
    return column;
  }

  // Returns whether the name is an angle's. If so, the column becomes that angle, unless the name is weak.
  bool read_as_angle(Column& column, std::string_view bare, std::string_view unit) {
    const std::optional<AngleName> angle = angle_named(bare);
    if (!angle || !(unit.empty() || is_angle_unit(unit))) return false;
    if (facts_.is_plain && !is_plain_angle_name(column.name)) return false;
    angles_.back() = angle;
    angles_.back()->is_weak = angle->is_weak && unit.empty();
    if (!unit.empty()) column.unit = unit_named(unit);
    column.is_elevation = angle->quantity == AngleName::Quantity::elevation;
    if (!angles_.back()->is_weak) column.kind = Column::Kind::angle;
    return true;
  }

  static bool read_as_rotation(Column& column, std::string_view bare, std::string_view unit) {
    if (!is_rotation_name(bare) || !(unit.empty() || is_angle_unit(unit))) return false;
    column.kind = Column::Kind::rotation;
    if (!unit.empty()) column.unit = unit_named(unit);
    return true;
  }

  bool read_as_wavelength(Column& column) {
    const auto found = wavelength_column(column.name);
    if (!found) return false;
    if (!found->fault.empty())
      refuse(out_.columns.size(), ColumnDoubt::Of::unit, "column " + shown(column.name) + " " + found->fault);
    column.kind = Column::Kind::wavelength;
    column.unit = found->unit;
    return true;
  }

  // Returns whether a line above the header states the polar angle of this side.
  bool is_stated_above(AngleSide side) const {
    return facts_.stated_angles && facts_.stated_angles->has(side == AngleSide::light ? 0 : 2);
  }

  // Returns whether the header has an azimuth, or otherwise a polar angle or elevation, of this side.
  bool states(bool azimuth, AngleSide side) const {
    return std::ranges::any_of(angles_, [&](const auto& angle) {
      return angle && !angle->is_weak && is_azimuth(*angle) == azimuth && angle->side == side;
    });
  }

  static bool is_azimuth(const AngleName& angle) { return angle.quantity == AngleName::Quantity::azimuth; }

  // Returns the side of an angle. theta_s next to an incident direction belongs to the scattered one; phi
  // next to phi_r belongs to the light.
  AngleSide side_of(std::size_t k) {
    const AngleName& angle = *angles_[k];
    const bool light = states(is_azimuth(angle), AngleSide::light),
               viewer = states(is_azimuth(angle), AngleSide::viewer);
    if (angle.is_bare_phi && light != viewer) return light ? AngleSide::viewer : AngleSide::light;
    if (angle.side == AngleSide::none) alone_ = k;
    if (angle.side != AngleSide::scatter_or_source)
      return angle.side == AngleSide::light ? AngleSide::light : AngleSide::viewer;
    // The only azimuth belongs to the side that the polar angles leave to the same letter.
    if (!light && !viewer && is_azimuth(angle) &&
        states(false, AngleSide::light) != states(false, AngleSide::viewer))
      return states(false, AngleSide::light) ? AngleSide::viewer : AngleSide::light;
    if (!light && !viewer && is_stated_above(AngleSide::light) != is_stated_above(AngleSide::viewer))
      return is_stated_above(AngleSide::light) ? AngleSide::viewer : AngleSide::light;
    if (light == viewer)
      refuse(k, ColumnDoubt::Of::meaning,
             "column " + shown(names_[k]) + " may belong to the incident or to the scattering direction: " +
                 (light ? "other columns give both" : "no other column gives one of the two"));
    return light ? AngleSide::viewer : AngleSide::light;
  }

  // Places an angle of a road table if this column has its name. Returns whether it does.
  static bool read_as_road_angle(Column& column) {
    for (const auto& [bare, unit] : ways_to_part(column.name)) {
      const std::optional<RoadAngle> road = road_angle_named(bare);
      if (!road) continue;
      const bool is_tangent = road == RoadAngle::tangent, is_viewer = road == RoadAngle::viewer;
      if (!(unit.empty() || (is_angle_unit(unit) && !is_tangent))) continue;
      column.kind = Column::Kind::angle;
      column.index = road == RoadAngle::azimuth ? 1 : is_viewer ? 2 : 0;
      column.is_tangent = is_tangent;
      column.is_elevation = is_viewer;
      if (!unit.empty() || is_tangent) column.unit = unit_named(unit.empty() ? "deg" : unit);
      return true;
    }
    return false;
  }

  // Places the angles of an r-table of road lighting with a row for each value: beta and tan gamma (or
  // gamma), and possibly the viewer's angle alpha above the road. beta is 0 on the mirror side. Returns false
  // if the table has other angles or lacks one of the two.
  bool place_road() {
    if (std::ranges::any_of(angles_, [](const auto& angle) { return angle && !angle->is_weak; }))
      return false;
    std::vector<Column> columns = out_.columns;
    std::array<std::size_t, 3> times{};
    for (Column& column : columns)
      if (column.kind == Column::Kind::value && read_as_road_angle(column)) ++times[column.index];
    if (times[0] != 1 || times[1] != 1 || times[2] > 1) return false;
    out_.columns = std::move(columns);
    out_.is_road = true;
    constexpr double kRoadViewer = 89, kMirrorSide = 180;  // degrees
    Column constant;
    constant.kind = Column::Kind::angle;
    if (times[2] == 0) {
      constant.index = 2;
      out_.constants.emplace_back(constant, kRoadViewer);
    }
    constant.index = 3;
    out_.constants.emplace_back(constant, kMirrorSide);
    out_.assume("an r-table of road lighting: the azimuth beta is 0 on the mirror side, and the viewer is " +
                std::string(times[2] == 0 ? "1 degree" : "alpha degrees") + " above the road");
    out_.notes.push_back("fit and study need --max-theta 90 for this table");
    return true;
  }

  // Sets the index of each angle's column. Ambiguous names are decided by the other columns.
  void place_angles() {
    std::map<std::size_t, std::string> taken;
    for (std::size_t k = 0; k < out_.columns.size(); ++k) {
      if (!angles_[k] || angles_[k]->is_weak) continue;
      Column& column = out_.columns[k];
      column.index = (side_of(k) == AngleSide::light ? 0 : 2) + (is_azimuth(*angles_[k]) ? 1 : 0);
      const auto [first, is_new] = taken.emplace(column.index, std::string(names_[k]));
      const std::string ours(kAngleNames[column.index]);
      if (!is_new)
        refuse(k, ColumnDoubt::Of::meaning,
               "columns " + shown(first->second) + " and " + shown(names_[k]) + " are both " + ours);
      announce_angle(column, ours);
    }
    for (const std::size_t angle : {0, 2}) place_stated_angle(angle);
    place_weak_angles();
    const bool of_light = out_.has_angle(1), of_viewer = out_.has_angle(3);
    if (of_light != of_viewer) out_.only_azimuth = of_light ? 1 : 3;
    out_.in_plane = !of_light && !of_viewer;
    if (out_.in_plane) place_phase();
    if (alone_ && of_light && of_viewer)
      refuse(*alone_, ColumnDoubt::Of::meaning,
             "column " + shown(names_[*alone_]) +
                 " does not name the direction of its azimuth, and another column gives " +
                 std::string(kAngleNames[1]));
    refuse_other_angles();
  }

  // Accepts a polar angle that a line above the header row states, if no column is this angle and a column is
  // the other one.
  void place_stated_angle(std::size_t angle) {
    const auto side = [](std::size_t a) { return a == 0 ? AngleSide::light : AngleSide::viewer; };
    if (!facts_.stated_angles || out_.has_angle(angle) || weak_angle(side(angle)) ||
        !(out_.has_angle(2 - angle) || weak_angle(side(2 - angle))))
      return;
    const StatedAngle* stated = facts_.stated_angles->find(angle, facts_.where);
    if (!stated) return;
    out_.constants.emplace_back(stated->column, stated->number);
    out_.assume(std::string(kAngleNames[angle]) + " is " + to_text(stated->degrees()) +
                " degrees in all rows, as line " + std::to_string(stated->line) + " states");
  }

  // Accepts a phase angle in place of the azimuths.
  void place_phase() {
    for (Column& column : out_.columns) {
      if (column.kind != Column::Kind::value || !out_.in_plane) continue;
      for (const auto& [bare, unit] : ways_to_part(column.name)) {
        if (!is_phase_name(bare) || !(unit.empty() || is_angle_unit(unit))) continue;
        column.kind = Column::Kind::phase;
        if (!unit.empty()) column.unit = unit_named(unit);
        out_.in_plane = false;
        out_.assume("column " + shown(column.name) +
                    " is read as the angle between the incident and the viewing direction, which gives the "
                    "azimuth between them without its sign");
        break;
      }
    }
  }

  // Accepts a word of several meanings as a polar angle if the table lacks that angle, states the other
  // polar angle, and has another column of values.
  void place_weak_angles() {
    const auto light = weak_angle(AngleSide::light), viewer = weak_angle(AngleSide::viewer);
    const bool has_light = out_.has_angle(0), has_viewer = out_.has_angle(2);
    std::vector<std::pair<std::size_t, std::size_t>> found;
    if (!has_light && light && (has_viewer || viewer)) found.emplace_back(*light, 0);
    if (!has_viewer && viewer && (has_light || light)) found.emplace_back(*viewer, 2);
    const auto values = std::size_t(
        std::ranges::count_if(out_.columns, [](const Column& c) { return c.kind == Column::Kind::value; }));
    if (values <= found.size() && facts_.needs_values) return;
    for (const auto& [k, angle] : found) {
      Column& column = out_.columns[k];
      column.kind = Column::Kind::angle;
      column.index = angle;
      announce_angle(column, std::string(kAngleNames[angle]));
    }
  }

  // Returns the only column with a weak name of this side, or std::nullopt.
  std::optional<std::size_t> weak_angle(AngleSide side) const {
    std::optional<std::size_t> found;
    for (std::size_t k = 0; k < angles_.size(); ++k) {
      if (!angles_[k] || !angles_[k]->is_weak || angles_[k]->side != side) continue;
      if (found) return std::nullopt;
      found = k;
    }
    return found;
  }

  // Refuses an angle that is not read if the angle that it replaces is missing.
  void refuse_other_angles() const {
    const bool lacks_polar = !out_.has_angle(0) || !out_.has_angle(2);
    if (!lacks_polar) refuse_unknown_azimuths();
    for (std::size_t k = 0; k < out_.columns.size(); ++k)
      for (const auto& [bare, unit] : ways_to_part(out_.columns[k].name)) {
        const auto refused = refused_angle(bare);
        if (refused && lacks_polar)
          refuse(k, ColumnDoubt::Of::meaning,
                 "column " + shown(out_.columns[k].name) + " " + refused->reason);
      }
  }

  // Refuses an azimuth whose direction its name does not give if the table lacks an azimuth: without this
  // column, directions outside the plane of incidence would be read as directions within the plane.
  void refuse_unknown_azimuths() const {
    if ((out_.has_angle(1) && out_.has_angle(3)) || out_.has(Column::Kind::phase)) return;
    for (std::size_t k = 0; k < out_.columns.size(); ++k) {
      const Column& column = out_.columns[k];
      if (column.kind == Column::Kind::value && is_like_azimuth(column.name))
        refuse(
            k, ColumnDoubt::Of::meaning,
            "column " + shown(column.name) +
                " seems to be an azimuth, but its name does not give the direction: name the column phi_i, "
                "phi_o or relative azimuth");
    }
  }

  void announce_angle(const Column& column, const std::string& ours) {
    const bool is_radians = column.unit && column.unit->factor == 1;
    announce(column.name,
             ours + (column.is_elevation ? " = 90 - elevation" : "") + (is_radians ? " in radians" : ""));
  }

  void announce_bands_and_turns() {
    for (const Column& column : out_.columns) {
      const bool is_nm = column.unit && column.unit->factor == 1e-9;
      if (column.kind == Column::Kind::wavelength && column.unit && !is_nm)
        announce(column.name, "wavelengths in nm");
      if (column.kind == Column::Kind::rotation)
        announce(column.name, "sample rotation (subtracted from the azimuths)");
    }
  }

  void note_the_only_azimuth() {
    const std::size_t stated = *out_.only_azimuth, other = 4 - stated;
    const auto column = std::ranges::find_if(
        out_.columns, [&](const Column& c) { return c.kind == Column::Kind::angle && c.index == stated; });
    out_.assume("only one azimuth, " + shown(column->name) + ": interpreted as " +
                std::string(kAngleNames[stated]) + " with " + std::string(kAngleNames[other]) +
                " 0, so that the mirror direction is at 180 degrees");
  }

  const std::vector<std::string_view>& names_;
  HeaderFacts facts_;
  Columns out_;
  std::vector<std::optional<AngleName>> angles_;  // the meaning of each column's name
  std::optional<std::size_t> alone_;              // the column of an azimuth of unstated side
  std::string read_as_;
};

// Returns the number of degrees with the fewest digits that equals this angle to its last bit, because
// instruments write 30 degrees as 0.5235987755982988.
double shortest_degrees(double radian) {
  const double plain = radians(radian).degrees();
  for (double scale = 1; scale <= 1e12; scale *= 10) {
    const double shorter = std::round(plain * scale) / scale;
    const double back = degrees(shorter).radians();
    if (std::abs(back - radian) <= std::abs(std::nextafter(radian, 4.0) - radian)) return shorter;
  }
  return plain;
}

// Degrees stay unchanged.
double in_degrees(double value, const std::optional<Unit>& unit) {
  static const double degree = unit_named("deg")->factor;
  return !unit || unit->factor == degree ? value : shortest_degrees(value * unit->factor);
}

}  // namespace

double Column::converted(double value) const {
  if (is_tangent) return radians(std::atan(value)).degrees();
  if (kind == Kind::angle || kind == Kind::rotation || kind == Kind::phase)
    return is_elevation ? 90 - in_degrees(value, unit) : in_degrees(value, unit);
  if (kind == Kind::wavelength && unit) {
    const bool is_nm = unit->factor == 1e-9 && unit->kind() == Unit::Kind::length;
    return is_nm ? without_noise(value) : to_nm(value, *unit);
  }
  return value;
}

bool is_unit(std::string_view field) {
  if (field.size() > 1 && (field.front() == '[' || field.front() == '('))
    field = trimmed(field.substr(1, field.size() - 2));
  return field.empty() || field == "-" || unit_named(field);
}

bool names_angles(const std::vector<std::string_view>& names, std::size_t at_least) {
  std::size_t count = 0;
  bool has_light = false, has_azimuth = false;  // of a road table
  double number;
  for (const std::string_view name : names) {
    if (parse_number(name, number)) continue;  // most fields of a line that is no header row
    for (const auto& [bare, unit] : ways_to_part(name)) {
      const std::optional<RoadAngle> road = road_angle_named(bare);
      has_light = has_light || road == RoadAngle::tangent || road == RoadAngle::incidence;
      has_azimuth = has_azimuth || road == RoadAngle::azimuth;
      const auto angle = angle_named(bare);
      if (!angle || (angle->is_weak && unit.empty()) || !(unit.empty() || is_angle_unit(unit))) continue;
      ++count;
      break;
    }
  }
  return count >= at_least || (has_light && has_azimuth);
}

bool Columns::has_angle(std::size_t angle) const {
  const auto is_it = [&](const Column& c) { return c.kind == Column::Kind::angle && c.index == angle; };
  return std::ranges::any_of(columns, is_it) ||
         std::ranges::any_of(constants, [&](const auto& constant) { return is_it(constant.first); });
}

bool Columns::has(Column::Kind kind) const {
  return std::ranges::any_of(columns, [&](const Column& c) { return c.kind == kind; });
}

void Columns::assume(const std::string& sentence) {
  notes.push_back(sentence);
  assumptions.push_back(sentence);
}

Columns understand_columns(const std::vector<std::string_view>& names, const HeaderFacts& facts) {
  return HeaderReading(names, facts).result();
}

}  // namespace brdf::io
