// What snippets take from the files around them: constants and one-line functions that everybody writes
// alike.
#pragma once

#include <string>
#include <vector>

#include "shader/front/source.h"

namespace brdf::shader {

struct Usual {
  std::string preamble;            // their definitions
  std::vector<std::string> names;  // in the order of the list, without words that older GLSL had of its own
};

// Those that the text uses and does not define itself, in its language. `whole`: after the preprocessor, with
// all that it includes, so that whatever an included file defines, as a macro or as a constant, is not
// defined again.
Usual usual_of(const std::string& whole, Language language);

}  // namespace brdf::shader
