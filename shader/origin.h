// The origin of a shader as a material records it, so that the shader can be found again and verified.
#pragma once

#include <string>

#include "shader/choice.h"

namespace brdf::shader {

// Returns the file's text with every #include replaced by the text of the included file. Lines with
// instructions for this program (`//:`) are effective only in the shader's own file; in other files they
// are marked as included. An #include of a file that is not found is kept. Throws InputError if a file
// cannot be read, or if includes are nested too deeply.
std::string whole_text(const ShaderChoice& choice);

struct ShaderOrigin {
  ShaderChoice choice = {};  // with the file's path as opened from the current folder
  std::string sha256 = {};   // of the whole text
  std::string text = {};     // the whole text, if the material contains it; empty: the file contains it
  std::vector<std::string> texture_sha256 = {};  // of the files of the choice's textures, in their order
  bool relative = false;                         // the file was given by a relative path
};

// Returns the origin of a shader; if `embedded`, with the whole text for storage in a material. Throws the
// errors of whole_text(), and InputError if an embedded text is too large or not valid UTF-8.
ShaderOrigin origin_of(const ShaderChoice& choice, bool embedded);

}  // namespace brdf::shader
