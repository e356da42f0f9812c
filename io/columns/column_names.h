// Recognises the columns of a sample table by their names, as laboratories write them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "io/columns/quantities.h"
#include "io/columns/stated_quantity.h"
#include "io/columns/units.h"

namespace brdf::io {

class StatedAngles;

struct Column {
  // `aside`: a column without values; its cells are not read. `rotation`: the angle by which the sample was
  // rotated. `phase`: the angle between the two directions, which replaces the azimuths.
  enum class Kind {
    angle,
    value,
    sigma,
    wavelength,
    polarisation,
    rotation,
    phase,
    aside
  } kind = Kind::value;
  std::size_t index = 0;  // the index of the angle (kAngleNames) or of the channel
  std::string name;       // as in the file
  // The unit in the name of an angle or of wavelengths.
  std::optional<Unit> unit;
  bool is_elevation = false;
  bool is_tangent = false;  // the tangent of the angle
  // Of a column of uncertainties: the standard deviation is the cell divided by this factor, times the
  // value if the uncertainty is relative.
  double coverage = 1;
  bool is_relative = false;

  // Converts a number of the file to the table's unit: degrees from the normal, or nm. Wavelengths without
  // a unit stay unchanged. Radians become the shortest number of degrees that equals the angle.
  double converted(double value) const;
};

// The columns of the elements 12, 21 and 22 of a Mueller matrix, by number.
struct MuellerColumns {
  std::size_t m12 = 0, m21 = 0, m22 = 0;
  bool is_divided = false;  // the elements are divided by the first one
};

struct Columns {
  std::vector<Column> columns;
  // Angles, wavelengths and rotations that are the same in all rows and have no column, as written.
  std::vector<std::pair<Column, double>> constants;
  std::vector<std::string> channels;  // names without their units
  std::vector<Quantity> quantities;   // [channel] quantity of the file's values
  // Set if the columns have the elements that polarised channels need.
  std::optional<MuellerColumns> mueller;
  // The index of the only azimuth, if one azimuth is stated for both directions.
  std::optional<std::size_t> only_azimuth;
  // A column of values names no quantity, and no quantity is stated.
  bool has_unnamed = false;
  // No azimuth is stated: the polar angles are signed, in the plane of incidence.
  bool in_plane = false;
  // An r-table of road lighting with a row for each value.
  bool is_road = false;
  // Interpretations that differ from the plain format, one sentence each.
  std::vector<std::string> notes;
  // The notes on which values or directions depend.
  std::vector<std::string> assumptions;

  // Returns whether a column or a constant is the angle with this index of kAngleNames.
  bool has_angle(std::size_t angle) const;
  bool has(Column::Kind kind) const;
  // Adds a note that is an assumption.
  void assume(const std::string& sentence);
};

// A column whose interpretation is open, although the reader would refuse the table for it.
struct ColumnDoubt {
  enum class Of { meaning, unit, quantity } of;
  std::size_t column;
  std::string reason;
};

// Facts about a table in addition to the names of its columns.
struct HeaderFacts {
  std::string where;  // opens messages
  std::optional<StatedQuantity> stated;
  bool needs_values = true;
  std::vector<bool> is_text = {};  // [column] the cells are not numbers
  // The angles have their plain names, and other columns are not angles. A column name without a meaning
  // then denotes f_r, and no note is added.
  bool is_plain = false;
  // The file's format stores f_r only. Columns X, Y and Z are then f_r too.
  bool is_format = false;
  // A table in our own format that states f_r. All columns other than angles are channels, whatever their
  // names.
  bool keeps_names = false;
  // The angles that lines above the header row state, used for polar angles without a column.
  const StatedAngles* stated_angles = nullptr;
  // If set, the reasons against reading columns are added here instead of thrown, for a proposal of a
  // layout (io/csv/describe_table.h). The columns concerned stay as far as they were understood.
  std::vector<ColumnDoubt>* doubts = nullptr;
};

// Returns whether a field is a unit that a column's name may have, with or without brackets: deg, [rad],
// 1/sr, nm. An empty field and "-" count as units.
bool is_unit(std::string_view field);

// Returns whether a row of names is a header row, that is, names at least two angles, or `at_least` ones.
bool names_angles(const std::vector<std::string_view>& names, std::size_t at_least = 2);

// Interprets a header row. `names` may be:
// - the plain names theta_i, phi_i, theta_o, phi_o, sigma_CHANNEL;
// - their usual aliases in any case and with blanks, hyphens or underscores (thetai, incidence, theta_r,
//   view zenith, azimuth, ...; docs/formats.md has the list), with units in brackets or as a suffix;
// - the words of quantities.
// theta_s is the scattered direction next to an incident direction, and the source's direction next to a
// reflected direction. If the header has the four plain names and a comment states f_r, all other columns
// are channels of f_r, whatever their names. Throws InputError, which quotes the names, if a column is
// ambiguous or cannot be read.
Columns understand_columns(const std::vector<std::string_view>& names, const HeaderFacts& facts);

}  // namespace brdf::io
