// Runs the compiler itself, in the current process.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "shader/front/source.h"

namespace brdf::shader {

// A function or declaration that does not compile and that other functions may not need.
struct LeftOut {
  std::string name, why;  // "FILE:LINE: ..."
  std::string text = {};  // its text, without comments
  bool is_declaration = false;
};

struct Translated {
  std::vector<std::uint32_t> spirv;  // empty: `messages` gives the reason
  std::string note, messages;
  std::string file;                           // of the first message, with the path that Files uses
  std::uint32_t line = 0;                     // of the first message; 0: unknown
  std::vector<LeftOut> left_out = {};         // parts that were left out so that the rest compiles
  std::vector<std::string> missing = {};      // names of includes without a file, in quotes
  std::vector<std::string> asked = {};        // macros that the text tests but nothing defines
  std::vector<std::string> unmentioned = {};  // macros of the command line that no file mentions
  std::string narrow_word = {};  // a type of 16 bits in the text: mediump, lowp, half, min16float
  bool ignores_narrow = false;   // such types were compiled as types of 32 bits
  std::string whole = {};        // the text with its includes, macros replaced, comments removed
};

// The information on source places that the module contains. More information uses more parts of the
// compiler that may fail.
enum class Places { scopes, lines, none };

// Initialises the compiler's own tables. Call it before translate(); only the first call in a process has
// an effect.
void prepare_translation();
// Translates the whole text. If this fails, translates the text without the functions and declarations, of
// the file itself or of included files, that do not compile.
Translated translate(const Source& source, Places places = Places::scopes);

// Returns "'a', 'b' are no files of the shader's own folder".
std::string no_files(const std::vector<std::string>& names, const Source& source);

}  // namespace brdf::shader
