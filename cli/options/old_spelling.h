#pragma once

#include <string>
#include <vector>

namespace brdf::cli {

// Returns the command line in the spelling that the parser knows; `words` begin with the verb. `help`,
// `help VERB` and `version` become options. Up to 0.1 `brdf render` did the work of `lobes`, `parity` and
// `maps`: these spellings are accepted until 0.3, with a note on stderr. Other command lines are returned
// unchanged.
std::vector<std::string> in_new_spelling(std::vector<std::string> words);

}  // namespace brdf::cli
