// Names of columns that stand beside values of f_r: their standard deviations, elements of a Mueller matrix.
#pragma once

#include <optional>
#include <string>

namespace brdf::io {

// The name that stands beside a word for standard deviations; empty if the word is all. std::nullopt without
// such a word.
std::optional<std::string> deviation_of(const std::string& name);

// "11" to "44" of m12, M12, fr12, f_r12/f_r11; empty for any other name.
std::string mueller_element(const std::string& name);

}  // namespace brdf::io
