// What a compiler is given besides the file.
#pragma once

#include <string>
#include <vector>

#include "shader/front/includes.h"
#include "shader/front/source.h"

namespace brdf::shader {

// One way of making the text compile.
struct Attempt {
  int version;           // of GLSL
  std::string preamble;  // before the text
  std::string note;      // a sentence of what it assumes; may be empty
  bool again = false;    // without the new names of functions that shadow built-in ones
};

// Functions of the files that have the name of a built-in one; `file` is empty for the shader's own.
struct Shadow {
  std::string name, file;
  std::uint32_t line;
};
std::vector<Shadow> shadowed_builtins(const Files& files);

// What stands before the text in every attempt: the command line's macros among it.
std::string common_preamble(const Source& source);

// In the order in which they are tried: the file's own first.
std::vector<int> versions_of(const Source& source);

// In the order in which they are tried. `whole`: the text after the preprocessor, which has read all the
// files.
std::vector<Attempt> attempts(const Files& files, const Source& source, const std::string& whole);

// The text with an entry that a driver could call, at its end.
std::string with_entry(const std::string& text, Language language);

}  // namespace brdf::shader
