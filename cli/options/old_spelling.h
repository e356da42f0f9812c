#pragma once

#include <string>
#include <vector>

namespace brdf::cli {

// A command line of before 0.2, when `brdf render` made what `lobes`, `parity` and `maps` make, as it is said
// now; any other as it is. `words` begin with the verb. The old spelling is told on stderr; it goes with 0.3.
std::vector<std::string> in_new_spelling(std::vector<std::string> words);

}  // namespace brdf::cli
