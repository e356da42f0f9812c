// The text that a compiler gets in addition to the file.
#pragma once

#include <string>
#include <vector>

#include "shader/front/includes.h"
#include "shader/front/source.h"

namespace brdf::shader {

// One way to make the text compile.
struct Attempt {
  int version;           // GLSL version
  std::string preamble;  // inserted before the text
  std::string note;      // a sentence on its assumptions; may be empty
  // Without new names for functions that shadow built-in functions.
  bool again = false;
  // Keeps the types that a device may compute in 16 bits. Some texts compile only without this.
  bool narrow = false;
};

// Returns the first type of 16 bits in the text after the preprocessor: mediump or lowp, in HLSL half or
// min16float; empty if the text has no such type.
std::string narrow_word(const std::string& whole, Language language);

// A function of the files with the name of a built-in function; `file` is empty for the shader's own file.
struct Shadow {
  std::string name, file;
  std::uint32_t line;
};
// Returns these functions, each name once.
std::vector<Shadow> shadowed_builtins(const Files& files);

// Returns the text that precedes the shader in every attempt, including the command line's macros.
std::string common_preamble(const Source& source);

// Returns the versions in the order in which they are tried, the file's own version first.
std::vector<int> versions_of(const Source& source);

// Returns the attempts in the order in which they are tried. `whole`: the text after the preprocessor,
// which must have read all files.
std::vector<Attempt> attempts(const Files& files, const Source& source, const std::string& whole);

// Returns the text with an entry point at its end that a driver could call.
std::string with_entry(const std::string& text, Language language);

}  // namespace brdf::shader
