// What the columns of a sample table are, told by their names as laboratories write them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace brdf::io {

struct Column {
  enum class Kind { angle, value, sigma, wavelength, polarisation } kind = Kind::value;
  enum class Unit { as_is, radians, elevation, elevation_in_radians, micrometres } unit = Unit::as_is;
  std::size_t index = 0;  // the angle's (kAngleNames) or the channel's
  std::string name;       // as the file has it
  bool has_unit = false;  // of an angle: the name states its unit

  // The file's number in the unit of the table: degrees from the normal, nm; radians become the shortest number of
  // degrees that is that angle.
  double converted(double value) const;
};

struct Columns {
  std::vector<Column> columns;
  std::vector<std::string> channels;  // names without their units
  std::optional<std::size_t>
      only_azimuth;                // the angle's index, where one azimuth is stated for both directions
  std::vector<std::string> notes;  // what was understood though it is not the plain format, a sentence each

  bool has_angle(std::size_t angle) const;
  bool has(Column::Kind kind) const;
};

// Whether a column of this name holds wavelengths: `wavelength`, `lambda` or `wl` with or without a unit.
bool is_wavelength_name(std::string_view name);
// Whether a column of this name holds words for polarisations: `polarisation`, `polarization`.
bool is_polarisation_name(std::string_view name);

// Whether a field is a unit that a column's name may have, in brackets or not: deg, [rad], 1/sr, nm. So is nothing at all.
bool is_unit(std::string_view field);

// Understands a header row: the plain names theta_i, phi_i, theta_o, phi_o, sigma_CHANNEL; their usual aliases in any
// case and with blanks, hyphens or underscores (thetai, incidence, theta_r, view zenith, azimuth, ...; docs/formats.md
// has the list); units in brackets or as a suffix. theta_s is the scattered direction beside an incident one, the
// source's beside a reflected one. Throws InputError, which `where` opens, naming what was found.
Columns understand_columns(const std::vector<std::string_view>& names, const std::string& where);

}  // namespace brdf::io
