// What the columns of a table hold that are no angles, wavelengths or polarisations: values of f_r or of
// another quantity, standard deviations, or no values at all.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "io/columns/column_names.h"
#include "io/columns/quantities.h"

namespace brdf::io {

// Decides it for every column of the kind `value`: gives it its kind, index and quantity, makes the channels
// and adds notes on what was understood. `announce` is called with a column's name and what it is, where they
// differ. Throws InputError if the values are of a quantity that f_r cannot be made of, or that the file does
// not state.
void place_values(Columns& header, const HeaderFacts& facts,
                  const std::function<void(std::string_view, const std::string&)>& announce);

}  // namespace brdf::io
