#include "io/columns/stated_angles.h"

#include <algorithm>
#include <cmath>

#include "io/columns/angle_names.h"
#include "io/columns/name_unit.h"
#include "io/columns/plain_names.h"
#include "io/files/error.h"
#include "io/files/text.h"

namespace brdf::io {
namespace {

constexpr std::string_view kDigits = "0123456789";
constexpr std::string_view kNumber = "0123456789.+-eE";

// Returns the position behind the name: that of a separator, or of a blank in front of a number.
std::size_t end_of_name(std::string_view text) {
  const std::size_t separator = std::min(text.size(), text.find_first_of(":=,;\t"));
  for (std::size_t k = 1; k < separator; ++k) {
    const std::string_view rest = text.substr(k);
    if (text[k - 1] == ' ' && rest.find_first_of("+-.0123456789") == 0 &&
        rest.find_first_of(kDigits) != rest.npos)
      return k - 1;
  }
  return separator;
}

bool is_angle_unit_or_none(const std::optional<Unit>& unit) {
  return !unit || unit->kind() == Unit::Kind::angle;
}

}  // namespace

std::optional<StatedAngle> stated_angle(std::string_view text) {
  constexpr std::size_t kLongest = 100;         // bytes
  constexpr std::string_view kSigns = "#%!/ ";  // that open comments
  text = trimmed(text.substr(std::min(text.size(), text.find_first_not_of(kSigns))));
  const std::size_t end = end_of_name(text);
  if (text.size() > kLongest || end >= text.size()) return std::nullopt;
  StatedAngle stated;
  stated.column.kind = Column::Kind::angle;
  stated.column.name = trimmed(text.substr(0, end));
  const NameUnit named = parted(stated.column.name);
  const auto angle = angle_named(named.bare);
  if (!angle || angle->is_weak || angle->quantity == AngleName::Quantity::azimuth ||
      !is_angle_unit_or_none(named.unit) ||
      (angle->side != AngleSide::light && angle->side != AngleSide::viewer))
    return std::nullopt;
  stated.column.index = angle->side == AngleSide::light ? 0 : 2;
  stated.column.is_elevation = angle->quantity == AngleName::Quantity::elevation;
  std::string_view value = trimmed(text.substr(end + 1));
  while (!value.empty() &&
         std::string_view(",;").find(value.back()) != value.npos)  // empty cells of a program
    value = trimmed(value.substr(0, value.size() - 1));
  const std::size_t number = std::min(value.size(), value.find_first_not_of(kNumber));
  if (!parse_number(value.substr(0, number), stated.number)) return std::nullopt;
  stated.column.unit = named.unit;
  if (const std::string_view unit = trimmed(value.substr(number)); !unit.empty()) {
    stated.column.unit = unit_named(unit);
    if (!stated.column.unit || !is_angle_unit_or_none(stated.column.unit)) return std::nullopt;
  }
  return stated;
}

void StatedAngles::add(std::string_view text, std::size_t line) {
  std::optional<StatedAngle> stated = stated_angle(text);
  if (!stated) return;
  stated->line = line;
  all_.push_back(*std::move(stated));
}

bool StatedAngles::has(std::size_t angle) const {
  return std::ranges::any_of(all_, [&](const StatedAngle& stated) { return stated.column.index == angle; });
}

const StatedAngle* StatedAngles::find(std::size_t angle, const std::string& where) const {
  const StatedAngle* found = nullptr;
  for (const StatedAngle& stated : all_) {
    if (stated.column.index != angle) continue;
    const std::string line =
        "the angle " + to_text(stated.number) + " of line " + std::to_string(stated.line);
    if (!(std::abs(stated.degrees()) <= 90))
      throw InputError(where + ": " + line + " is beyond 90 degrees from the normal");
    if (found && stated.degrees() != found->degrees())
      throw InputError(where + ": " + line + " contradicts the angle " + to_text(found->number) +
                       " of line " + std::to_string(found->line) + ": add a column '" +
                       std::string(kAngleNames[angle]) + "' with the angle of each row");
    if (!found) found = &stated;
  }
  return found;
}

}  // namespace brdf::io
