#include "io/columns/aspecular_names.h"

#include <algorithm>
#include <cmath>

#include "io/columns/angle_names.h"
#include "io/files/text.h"

namespace brdf::io {
namespace {

// Removes a number of degrees from the beginning of `text`.
bool take_angle(std::string_view& text, double& angle) {
  const std::size_t end = std::min(text.find_first_not_of("+-.0123456789"), text.size());
  if (!parse_number(text.substr(0, end), angle)) return false;
  text.remove_prefix(end);
  return std::abs(angle) < 180;
}

// A small copy without blanks and underscores. Signs and points are kept.
std::string geometry_key(std::string_view name) {
  std::string key = lower_case(name);
  std::erase_if(key, [](char c) { return c == ' ' || c == '_'; });
  return key;
}

}  // namespace

std::optional<AspecularGeometry> aspecular_geometry(std::string_view name) {
  constexpr std::size_t kLongest = 40;
  if (name.size() > kLongest) return std::nullopt;
  const std::string key = geometry_key(name);
  std::string_view rest = key;
  AspecularGeometry found;
  if (key.starts_with("d/") || key.starts_with("di:") || key.starts_with("de:") || key.starts_with("d:") ||
      key.ends_with("/d") || key.ends_with(":di") || key.ends_with(":de")) {
    if (key.find_first_of("0123456789") == key.npos) return std::nullopt;
    found.fault = "is a geometry with an integrating sphere, whose values are not a BRDF";
    return found;
  }
  if (rest.starts_with('r')) rest.remove_prefix(1);
  if (!take_angle(rest, found.light)) return std::nullopt;
  double angle;
  if (rest.starts_with('/')) {
    rest.remove_prefix(1);
    if (!take_angle(rest, found.viewer) || !rest.empty()) return std::nullopt;
  } else {
    if (!rest.starts_with("as") && !rest.starts_with("a:")) return std::nullopt;
    rest.remove_prefix(2);
    if (!take_angle(rest, angle)) return std::nullopt;
    found.viewer = found.light - angle;
    if (rest.starts_with("az")) {
      found.fault =
          "leaves the plane of incidence and is not read: write columns theta_i, phi_i, theta_o, phi_o";
      return found;
    }
    if (!rest.empty()) return std::nullopt;
  }
  constexpr double kSteepest = 90 - 1e-6;
  if (!(std::abs(found.light) < kSteepest && std::abs(found.viewer) < kSteepest))
    found.fault = "has a direction below the horizon";
  return found;
}

}  // namespace brdf::io
