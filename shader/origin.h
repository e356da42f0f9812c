// Where a shader comes from: what a material says of it, so that it is found again and is the same.
#pragma once

#include <string>

#include "shader/choice.h"

namespace brdf::shader {

// The file's text with each file that it includes in the place of the #include; lines that say something to
// this program (`//:`) count in the shader's own file only, and are marked so in the others. What is not
// found stays an #include. Throws InputError where a file cannot be read, or includes are nested too deeply.
std::string whole_text(const ShaderChoice& choice);

struct ShaderOrigin {
  ShaderChoice choice = {};  // its file as it is opened from here
  std::string sha256 = {};   // of its whole text
  std::string text = {};     // that, where the material itself holds it; empty: the file does
  bool relative = false;     // it was named by a relative path
};

// The whole text as a material can hold it. Throws InputError where it is too large or no UTF-8.
ShaderOrigin origin_of(const ShaderChoice& choice, bool embedded);

}  // namespace brdf::shader
