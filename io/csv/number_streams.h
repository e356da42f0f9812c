// Files of numbers without a header row.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/files/content.h"

namespace brdf::io {

// What to write above the numbers of a file whose first row has these fields, as the end of a sentence: the
// header row that their number and sizes suggest, or the name of a known format that is not read.
std::string header_for_numbers(const Content& content, const std::vector<std::string_view>& first_row);

}  // namespace brdf::io
