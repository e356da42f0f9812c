#include "io/csv/matrix_header.h"

#include <cmath>

#include "io/columns/angle_names.h"
#include "io/files/text.h"

namespace brdf::io {
namespace {

// Returns the polar angle of this name, or std::nullopt. `other`: the side of the other axis, if known;
// theta_s belongs to the opposite side.
std::optional<Column> axis_named(std::string_view name, std::optional<AngleSide> other) {
  for (const auto& [bare, unit] : ways_to_part(trimmed(name))) {
    const auto angle = angle_named(bare);
    const auto named = unit_named(unit);
    if (!angle || angle->quantity == AngleName::Quantity::azimuth) continue;
    if (!unit.empty() && !(named && named->kind() == Unit::Kind::angle)) continue;
    Column column;
    column.kind = Column::Kind::angle;
    column.name = name;
    column.unit = named;
    column.is_elevation = angle->quantity == AngleName::Quantity::elevation;
    const bool is_light = angle->side == AngleSide::scatter_or_source ? other == AngleSide::viewer
                                                                      : angle->side == AngleSide::light;
    column.index = is_light ? 0 : 2;
    return column;
  }
  return std::nullopt;
}

AngleSide side_of(const Column& column) {
  return column.index == 0 ? AngleSide::light : AngleSide::viewer;
}

// Returns an axis of an r-table. beta is 0 on the mirror side, so that it becomes phi_i of a viewer at
// azimuth 180 degrees.
std::optional<Column> road_axis(std::string_view name) {
  for (const auto& [bare, unit] : ways_to_part(trimmed(name))) {
    const std::optional<RoadAngle> road = road_angle_named(bare);
    const bool is_tangent = road == RoadAngle::tangent, is_azimuth = road == RoadAngle::azimuth;
    const auto named = unit_named(unit);
    if (!(is_tangent || is_azimuth) || !(unit.empty() || (named && named->kind() == Unit::Kind::angle)))
      continue;
    Column column;
    column.kind = Column::Kind::angle;
    column.name = name;
    column.unit = named ? named : unit_named("deg");
    column.is_tangent = is_tangent;
    column.index = is_tangent ? 0 : 1;
    return column;
  }
  return std::nullopt;
}

// Reads the first cell of an r-table: 'tan gamma \\ beta', the reverse, or one of the two.
bool read_road_axes(std::string_view cell, MatrixHeader& out) {
  for (const char sign : {'\\', '|', '/'}) {
    const std::size_t at = cell.find(sign);
    if (at == cell.npos) continue;
    const auto down = road_axis(cell.substr(0, at)), along = road_axis(cell.substr(at + 1));
    if (!down || !along || down->index == along->index) continue;
    out.rows = *down;
    out.columns = *along;
    return true;
  }
  const auto only = road_axis(cell);
  if (!only || !only->is_tangent) return false;
  out.rows = *only;
  out.columns = *road_axis("beta");
  return true;
}

// Reads the first cell. The cell is split if both parts are angles.
bool read_axes(std::string_view cell, MatrixHeader& out) {
  for (const char sign : {'\\', '|', '/'}) {
    const std::size_t at = cell.find(sign);
    if (at == cell.npos) continue;
    auto down = axis_named(cell.substr(0, at), std::nullopt);
    const auto along = axis_named(cell.substr(at + 1), down ? std::optional(side_of(*down)) : std::nullopt);
    if (!down || !along) continue;
    down = axis_named(cell.substr(0, at), side_of(*along));
    if (down->index == along->index) return false;
    out.rows = *down;
    out.columns = *along;
    return true;
  }
  const auto only = axis_named(cell, std::nullopt);
  if (!only) return false;
  out.rows = out.columns = *only;
  out.columns.index = 2 - only->index;
  out.columns.name = "the header row";
  return true;
}

}  // namespace

std::optional<MatrixHeader> matrix_header(const std::vector<std::string_view>& names, Dialect& dialect) {
  MatrixHeader out;
  if (names.size() < 2) return std::nullopt;
  out.is_road = read_road_axes(names[0], out);
  if (!out.is_road && !read_axes(names[0], out)) return std::nullopt;
  const double largest = out.columns.index % 2 == 0 ? 90 : 360;
  for (std::size_t k = 1; k < names.size(); ++k) {
    double angle;
    if (!dialect.parse(names[k], angle) || !(std::abs(out.columns.converted(angle)) <= largest))
      return std::nullopt;
    out.angles.push_back(angle);
  }
  return out;
}

}  // namespace brdf::io
