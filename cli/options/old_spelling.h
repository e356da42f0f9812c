// Support for command lines in the spelling of earlier versions.
#pragma once

#include <string>
#include <vector>

namespace brdf::cli {

// Translates a command line from before version 0.2, in which `brdf render` did the work of `lobes`,
// `parity` and `maps`, to the present spelling. Any other command line is returned unchanged. `words` begin
// with the verb. A message on stderr reports the old spelling, which will be removed in 0.3.
std::vector<std::string> in_new_spelling(std::vector<std::string> words);

}  // namespace brdf::cli
