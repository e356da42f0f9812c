// Recognises the names that laboratories give to the angles of a table.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace brdf::io {

enum class AngleSide { light, viewer, scatter_or_source, none };

// The meaning of an angle's name.
struct AngleName {
  enum class Quantity { polar, elevation, azimuth } quantity;
  // The direction of the angle. theta_s and phi_s belong to the scattered direction or to the source,
  // depending on the other columns. `none`: an azimuth without a direction.
  AngleSide side;
  // A word that also has other meanings (`source`, `measurement`, `i`). The column is an angle only if no
  // other column is this angle.
  bool is_weak = false;
  // Bare `phi`. Next to the azimuth of one direction, `phi` is the azimuth of the other; a relative azimuth
  // never is.
  bool is_bare_phi = false;
};

// Returns a name in small letters, with Greek letters spelled out, without blanks, points, hyphens,
// underscores and backslashes.
std::string plain_spelling(std::string_view name);

// Returns the meaning of an angle's name without its unit, or std::nullopt if the name is not an angle's.
// The list of names is in docs/formats.md.
std::optional<AngleName> angle_named(std::string_view name);

// Returns whether the name has the word of an azimuth, whichever direction the azimuth belongs to: Phi_diff,
// "Azimut Ausfall", "detector azimuth (deg)".
bool is_like_azimuth(std::string_view name);

// Returns whether the name is that of the phase angle, between the directions of the light and the viewer.
bool is_phase_name(std::string_view name);
// An angle of an r-table of road lighting: the angle of incidence (gamma) or its tangent (tan gamma), the
// azimuth (beta), and the viewer's angle above the road (alpha), of a table with a row for each value.
enum class RoadAngle { tangent, incidence, azimuth, viewer };
std::optional<RoadAngle> road_angle_named(std::string_view name);

// An angle that is recognised but not read: an angle from the mirror direction, a sine.
struct RefusedAngle {
  std::string reason;  // the end of a sentence about the column
};
// Returns the reason against reading a column of this name, or std::nullopt if the name is not such an
// angle's.
std::optional<RefusedAngle> refused_angle(std::string_view name);

}  // namespace brdf::io
