// What the columns of a sample table are, told by their names as laboratories write them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/columns/quantities.h"
#include "io/columns/stated_quantity.h"
#include "io/columns/units.h"

namespace brdf::io {

struct Column {
  // `aside`: no values, its cells are not looked at. `rotation`: the angle by which the sample was turned.
  enum class Kind { angle, value, sigma, wavelength, polarisation, rotation, aside } kind = Kind::value;
  std::size_t index = 0;  // the angle's (kAngleNames) or the channel's
  std::string name;       // as the file has it
  // Of an angle or of wavelengths: the unit that the name states.
  std::optional<Unit> unit;
  bool is_elevation = false;

  // The file's number as the table has it: degrees from the normal, nm (wavelengths without a unit as they
  // are). Radians become the shortest number of degrees that is that angle.
  double converted(double value) const;
};

struct Columns {
  std::vector<Column> columns;
  std::vector<std::string> channels;  // names without their units
  std::vector<Quantity> quantities;   // [channel] of the file's values
  std::optional<std::size_t>
      only_azimuth;          // the angle's index, where one azimuth is stated for both directions
  bool has_unnamed = false;  // a column of values names no quantity, and none is stated
  bool in_plane = false;     // no azimuth is stated: the polar angles are signed, in the plane of incidence
  std::vector<std::string> notes;  // what was understood though it is not the plain format, a sentence each
  std::vector<std::string> assumptions;  // those on which values or directions rest

  bool has_angle(std::size_t angle) const;
  bool has(Column::Kind kind) const;
  // Adds a note that is an assumption.
  void assume(const std::string& sentence);
};

// What is known of a table beside the names of its columns.
struct HeaderFacts {
  std::string where;  // opens messages
  std::optional<StatedQuantity> stated;
  bool needs_values = true;
  std::vector<bool> is_text = {};  // [column] cells that are no numbers
  bool is_plain = false;   // the plain names of the angles: a name that says nothing is f_r without a word
  bool is_format = false;  // so of a format that is one of f_r, in which X, Y and Z are f_r, too
  // A table that states f_r in our own way: all columns that are no angles are channels, whatever their names
  // are.
  bool keeps_names = false;
};

// Whether a field is a unit that a column's name may have, in brackets or not: deg, [rad], 1/sr, nm. So is
// nothing at all.
bool is_unit(std::string_view field);

// Whether a row of names is a header row: at least two of them are angles'.
bool names_angles(const std::vector<std::string_view>& names);

// Understands a header row: the plain names theta_i, phi_i, theta_o, phi_o, sigma_CHANNEL; their usual
// aliases in any case and with blanks, hyphens or underscores (thetai, incidence, theta_r, view zenith,
// azimuth, ...; docs/formats.md has the list); units in brackets or as a suffix; the words of quantities.
// theta_s is the scattered direction beside an incident one, the source's beside a reflected one. If the four
// plain names are there and a comment states f_r, all other columns are channels of f_r, whatever their names
// are. Throws InputError naming what was found.
Columns understand_columns(const std::vector<std::string_view>& names, const HeaderFacts& facts);

}  // namespace brdf::io
