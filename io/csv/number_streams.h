// Gives advice on files of numbers without a header row.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/files/content.h"

namespace brdf::io {

// Returns the header row to write above the numbers of a file, as the end of a sentence. `first_row`: the
// fields of the first row. The header row is guessed from the number of columns and the sizes of the
// numbers.
std::string header_for_numbers(const Content& content, const std::vector<std::string_view>& first_row);

}  // namespace brdf::io
