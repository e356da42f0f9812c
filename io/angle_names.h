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
};

// A name in small letters, Greek ones by their names, without blanks, points, hyphens and underscores.
std::string plain_spelling(std::string_view name);

// What the name of an angle, without its unit, says; nothing where it is no angle's. docs/formats.md has the list.
std::optional<AngleName> angle_named(std::string_view name);

}  // namespace brdf::io
