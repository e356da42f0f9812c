// The unit that stands in a column's name.
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

// Finds a unit in brackets, from the right; else the longest one behind `/`, `,`, `_` or a blank; or the
// whole name is one. The number of a wavelength (550 nm), a polarisation (s) and letters that mean much else
// are no units.
NameUnit parted(std::string_view name);

}  // namespace brdf::io
