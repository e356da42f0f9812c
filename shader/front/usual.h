// What snippets take from the files around them: constants and one-line functions that everybody writes alike.
#pragma once

#include <string>
#include <vector>

#include "shader/front/source.h"

namespace brdf::shader {

struct Usual {
  std::string preamble;            // their definitions
  std::vector<std::string> names;  // in the order of the list
};

// Those that the text uses and does not define itself, in its language.
Usual usual_of(const std::string& text, Language language);

}  // namespace brdf::shader
