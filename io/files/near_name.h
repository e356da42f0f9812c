// Suggestions for misspelt names.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace brdf::io {

// Returns the known name that is most similar to `word`, or an empty string if no name is similar. A name
// that users of other programs know under `word` (io/material/familiar_names.cpp) comes first. Otherwise
// the name with the smallest edit distance is chosen: letters wrong, doubled, left out or exchanged, at
// most a third of the letters (one letter in short words). A name that begins with `word` (three letters or
// more) counts as at most one edit. The first of several equally near names wins. Case, '-', '_' and blanks
// make no difference.
std::string near_name(std::string_view word, const std::vector<std::string>& known);

// Returns "did you mean alpha? ", or an empty string.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& known);

// Returns "known: a, b", preceded by did_you_mean().
std::string known_names_text(std::string_view word, const std::vector<std::string>& known);

// Returns "; did you mean copper.csv?" for a path that does not exist, chosen from the files of its folder,
// or an empty string.
std::string did_you_mean_file(std::string_view path);

// Returns our names for a name that is common in other programs, the most likely first. Empty if `word` is
// not such a name.
std::vector<std::string_view> familiar_names(std::string_view word);

}  // namespace brdf::io
