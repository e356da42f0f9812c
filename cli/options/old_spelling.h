// Support for command lines in the spelling of earlier versions.
#pragma once

#include <string>
#include <vector>

namespace brdf::cli {

// Translates a command line to the spelling that the parser knows; `words` begin with the verb. `help`,
// `help VERB` and `version` become options. Before version 0.2 `brdf render` did the work of `lobes`,
// `parity` and `maps`: these spellings are accepted until 0.3, with a message on stderr. Any other command
// line is returned unchanged.
std::vector<std::string> in_new_spelling(std::vector<std::string> words);

}  // namespace brdf::cli
