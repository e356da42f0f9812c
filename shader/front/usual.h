// Definitions that snippets expect from the surrounding files: constants and one-line functions that are
// written alike everywhere.
#pragma once

#include <string>
#include <vector>

#include "shader/front/source.h"

namespace brdf::shader {

struct Usual {
  std::string preamble;            // their definitions
  std::vector<std::string> names;  // in the order of the list, without the words of older GLSL
};

// Returns the definitions that the text uses but does not contain, in its language. `whole`: the text after
// the preprocessor, with all includes, so that a macro or a constant that an included file defines is not
// defined again.
Usual usual_of(const std::string& whole, Language language);

}  // namespace brdf::shader
