// A layout: a description of a laboratory's table in JSON, which makes the table readable without code
// (docs/formats.md; docs/layout.schema.json).
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "brdf/names.h"
#include "io/columns/quantities.h"
#include "io/columns/supplied.h"
#include "io/columns/units.h"

namespace brdf::io {

// The meaning of an entry of a layout.
enum class Meaning {
  theta_i,
  phi_i,
  theta_o,
  phi_o,
  phase,
  value,
  sigma,
  wavelength,
  polarisation,
  rotation,
  ignored
};

// The direction from which a polar angle is measured.
enum class From { normal, surface };

// A layout has at most so many entries, so that a hostile file costs little.
inline constexpr std::size_t kMostLayoutEntries = 5000;

// One entry of `columns`: a column by its name or position, or a constant in place of a column.
struct LayoutColumn {
  std::string path;                     // "$.columns[2]", for messages
  std::string name;                     // empty if the entry has a position or a constant
  std::optional<std::size_t> position;  // from 1
  std::optional<double> constant;
  Meaning is = Meaning::ignored;
  std::optional<Unit> unit;
  From from = From::normal;
  std::string channel;               // of `value`: the name of the channel; of `sigma`: the channel described
  std::optional<Quantity> quantity;  // of `value`
  double coverage = 1;               // of `sigma`: the coverage factor of the uncertainty
  bool is_relative = false;          // of `sigma`: a fraction of the value
};

struct Layout {
  std::string file;               // for messages
  std::optional<char> separator;  // ' ': blanks
  std::optional<char> decimal;
  std::string comment = "#";
  std::optional<std::size_t> header;  // the line of the header row; 0: the table has no header row
  std::optional<Quantity> quantity;
  MirrorSide mirror_side = MirrorSide::automatic;
  bool mirror_is_at_zero = false;  // the mirror direction is at phi_o = phi_i
  std::vector<std::string> fill_words;
  std::vector<double> fill_numbers;
  std::optional<double> aperture;  // degrees
  std::vector<LayoutColumn> columns;
  // The places that describe-table was unsure of, one sentence each.
  std::vector<std::string> guesses;

  // Returns the first entry with this meaning, or null.
  const LayoutColumn* find(Meaning meaning) const;
  // Returns whether the cell holds a fill value. `number`: the cell as a number, if it is one.
  bool is_fill(std::string_view cell, std::optional<double> number) const;
};

// Reads a layout: a file's name, or the JSON itself if the text begins with '{'. Throws InputError, which
// names the file, the path in the JSON, the value, the rule and the remedy, for unknown keys, keys without
// effect, entries that contradict each other, and places that are null because describe-table could not
// decide them.
Layout read_layout(const std::string& file_or_json);

// Returns the text of a layout for fingerprints; empty if `file_or_json` is empty.
std::string layout_text(const std::string& file_or_json);

}  // namespace brdf::io

namespace brdf {

template <>
inline constexpr std::array<std::string_view, 11> kNames<io::Meaning>{
    "theta_i", "phi_i",      "theta_o",      "phi_o",    "phase",  "value",
    "sigma",   "wavelength", "polarisation", "rotation", "ignored"};
template <>
inline constexpr std::array<std::string_view, 2> kNames<io::From>{"normal", "surface"};

}  // namespace brdf
