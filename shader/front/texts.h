// What a compiler is given besides the file.
#pragma once

#include <string>
#include <vector>

#include "shader/front/source.h"

namespace brdf::shader {

// One way of making the text compile.
struct Attempt {
  int version;           // of GLSL
  std::string preamble;  // before the text
  std::string note;      // a sentence of what it assumes; may be empty
  bool usual = false;    // with all that files leave to others
};

// Functions of the file that have the name of a built-in one, with their lines.
struct Shadow {
  std::string name;
  std::uint32_t line;
};
std::vector<Shadow> shadowed_builtins(const Source& source);

// In the order in which they are tried: the file's own version first.
std::vector<Attempt> attempts(const Source& source);

// The file's text with an entry that a driver could call, at its end.
std::string with_entry(const Source& source);

}  // namespace brdf::shader
