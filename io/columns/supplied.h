// What a caller states about a table because its file does not.
#pragma once

#include <string>

#include "brdf/names.h"

namespace brdf::io {

// In a table of two signed angles: the sign of the viewer's angle on the mirror side. `automatic`: the side
// of the largest values; if the values do not tell, positive.
enum class MirrorSide { automatic, positive, negative };

struct Supplied {
  std::string quantity;  // a name of quantities.h; empty: nothing is stated
  MirrorSide mirror_side = MirrorSide::automatic;

  bool operator==(const Supplied&) const = default;
};

}  // namespace brdf::io

namespace brdf {

template <>
inline constexpr std::array<std::string_view, 3> kNames<io::MirrorSide>{"auto", "positive", "negative"};

}  // namespace brdf
