// Separates the unit from a column's name.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "io/columns/units.h"

namespace brdf::io {

// A name without its unit, and the unit.
struct NameUnit {
  std::string bare;
  std::optional<Unit> unit;
  std::string unit_text;
};

// Separates a name and its unit. The unit is the whole name if that is one with a sign (1/sr, %) or dB;
// otherwise the last unit in brackets; otherwise the longest one after `/`, `,`, `_` or a blank. The number
// of a wavelength (550 nm), a polarisation (s) and letters with many other meanings are not units.
NameUnit parted(std::string_view name);

}  // namespace brdf::io
