// What was probably meant by a word that names nothing.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace brdf::io {

// The name that is nearest to the word: what other programs' users call it (io/material/familiar_names.cpp),
// else one that begins with it, else the one with the fewest letters wrong, doubled, left out or exchanged,
// at most a third of them. Capitals, '-' and '_' make no difference. Empty: none is near.
std::string near_name(std::string_view word, const std::vector<std::string>& known);

// "did you mean alpha? ", or nothing.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& known);

// "known: a, b", after what was probably meant.
std::string known_names_text(std::string_view word, const std::vector<std::string>& known);

// The same for a path that does not exist, by the files beside it; "; did you mean copper.csv?".
std::string did_you_mean_file(std::string_view path);

// The names that people who come from other programs try for this one, the likeliest first; none where it is
// not familiar.
std::vector<std::string_view> familiar_names(std::string_view word);

}  // namespace brdf::io
