// Advice on fields that are not numbers.
#pragma once

#include <string>
#include <string_view>

namespace brdf::io {

// Returns advice on a field that is not a finite number, as the end of a message: "; write no row where
// nothing was measured". Empty if the field resembles no known case.
std::string advice_on(std::string_view field);

// Returns whether a cell marks a row that summarises others: mean, average, total, std, ..., in any case.
bool is_summary_word(std::string_view field);

}  // namespace brdf::io
