// Recognises columns that accompany values of f_r: their standard deviations, elements of a Mueller matrix.
#pragma once

#include <optional>
#include <string>

namespace brdf::io {

// Returns the name that a word for standard deviations accompanies, or an empty string if the name is only
// such a word. Returns std::nullopt if the name has no such word.
std::optional<std::string> deviation_of(const std::string& name);

// Returns the element, "11" to "44", of names such as m12, M12, fr12, f_r12/f_r11; an empty string for any
// other name.
std::string mueller_element(const std::string& name);

}  // namespace brdf::io
