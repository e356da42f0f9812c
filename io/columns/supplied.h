// Facts about a table that the caller states because the file does not.
#pragma once

#include <string>

#include "brdf/names.h"

namespace brdf::io {

// The sign of the viewer's angle on the mirror side, in a table of two signed angles. `automatic`: the side
// of the largest values; positive if the values do not decide.
enum class MirrorSide { automatic, positive, negative };

struct Supplied {
  std::string quantity;  // a name of quantities.h; empty if not stated
  MirrorSide mirror_side = MirrorSide::automatic;
  // Read a Mueller matrix as the channels s, p, ss, sp, ps and pp instead of f_r of unpolarised light.
  bool polarised = false;
  // The description of the table's columns (io/columns/layout.h): the name of a file of JSON, or the JSON
  // itself, which begins with '{'. Empty: the header row is interpreted.
  std::string layout = {};
  // Words of the name of one of several matrices (Klems XML), such as "back solar"; empty: the usual matrix.
  std::string matrix = {};

  bool operator==(const Supplied&) const = default;
};

}  // namespace brdf::io

namespace brdf {

template <>
inline constexpr std::array<std::string_view, 3> kNames<io::MirrorSide>{"auto", "positive", "negative"};

}  // namespace brdf
