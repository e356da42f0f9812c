// Interprets the columns of a table other than angles, wavelengths and polarisations: values of f_r or of
// another quantity, standard deviations, or no values.
#pragma once

#include <functional>
#include <string>

#include "io/columns/column_names.h"
#include "io/columns/quantities.h"

namespace brdf::io {

// Interprets every column of the kind `value`. Sets the column's kind, index and quantity, creates the
// channels and adds notes on the interpretation. `announce` is called with a column's name and its
// interpretation; the two may be equal. Throws InputError if the quantity of the values cannot be converted
// to f_r, or is not stated by the file.
void place_values(Columns& header, const HeaderFacts& facts,
                  const std::function<void(std::string_view, const std::string&)>& announce);

}  // namespace brdf::io
