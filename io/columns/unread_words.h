// Finds the parts of a name that may change the meaning of the values and that no reader has interpreted:
// operators, functions, factors, units, and words such as "ratio" and "dark".
#pragma once

#include <optional>
#include <string>

#include "io/columns/quantity_words.h"

namespace brdf::io {

struct UnreadPart {
  std::string reason;       // the end of a sentence about the column
  bool is_derived = false;  // a number that accompanies the values: a minimum, a dark level, a difference
};

// Returns the first such part of a name whose words were read; std::nullopt if what is left is only a name:
// a band (550nm), a polarisation, a sample. The names of bands, polarisations, samples and geometries (45/0)
// have no such part.
std::optional<UnreadPart> unread_part(const QuantityWords& words);

}  // namespace brdf::io
