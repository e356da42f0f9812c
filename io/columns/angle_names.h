// The names that laboratories give to the angles of a table.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace brdf::io {

enum class AngleSide { light, viewer, scatter_or_source, none };

// What an angle's name says.
struct AngleName {
  enum class Quantity { polar, elevation, azimuth } quantity;
  // theta_s and phi_s are the scattered direction's or the source's: the names beside them decide. `none`: an
  // azimuth that does not say whose it is.
  AngleSide side;
  // A word that also has other meanings (`source`, `measurement`, `i`): an angle only if no other column is
  // this one.
  bool is_weak = false;
  // Bare `phi`, which beside the azimuth of one side is that of the other; a relative azimuth never is.
  bool is_bare_phi = false;
};

// A name in small letters, Greek ones by their names, without blanks, points, hyphens and underscores.
std::string plain_spelling(std::string_view name);

// What the name of an angle, without its unit, says; std::nullopt if it is no angle's. docs/formats.md has
// the list.
std::optional<AngleName> angle_named(std::string_view name);

// An angle that is not read: from the mirror direction, a sine, a phase angle.
struct RefusedAngle {
  std::string reason;            // as the end of a sentence about its column
  bool is_for_azimuths = false;  // it stands in place of the azimuths, else of a polar angle
};
std::optional<RefusedAngle> refused_angle(std::string_view name);

}  // namespace brdf::io
