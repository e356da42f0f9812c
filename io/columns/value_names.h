// Recognises columns that accompany values of f_r: their standard deviations, elements of a Mueller matrix.
#pragma once

#include <optional>
#include <string>

namespace brdf::io {

// Returns the name that a word for standard deviations accompanies, or an empty string if the name is only
// such a word. Returns std::nullopt if the name has no such word.
std::optional<std::string> deviation_of(const std::string& name);

// The words of an uncertainty that is not a standard deviation. `coverage`: the factor k of "(k=2)" and
// similar words, 1 without such words; 0 for an expanded uncertainty without its factor.
struct UncertaintyWords {
  double coverage = 1;
  bool is_relative = false;  // to the value
};
UncertaintyWords uncertainty_words(const std::string& name);

// Returns the place, "00" to "44", of names such as m12, M12, fr12, s12, f_r12/f_r11; an empty string for
// any other name.
std::string mueller_place(const std::string& name);

}  // namespace brdf::io
