// The compiler itself, in this process.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "shader/front/source.h"

namespace brdf::shader {

// A function or declaration that does not compile, which others may do without.
struct LeftOut {
  std::string name, why;  // "FILE:LINE: ..."
  std::string text = {};  // of it, without comments
  bool is_declaration = false;
};

struct Translated {
  std::vector<std::uint32_t> spirv;  // empty: `messages` say why
  std::string note, messages;
  std::string file;                           // of the first message: as Files names it
  std::uint32_t line = 0;                     // of the first message; 0: unknown
  std::vector<LeftOut> left_out = {};         // what the rest was compiled without
  std::vector<std::string> missing = {};      // included names that no file has, in quotes
  std::vector<std::string> asked = {};        // macros that the text asks for and that nothing defines
  std::vector<std::string> unmentioned = {};  // macros of the command line that no file mentions
  std::string whole = {};                     // the text with its includes, macros replaced, comments gone
};

// What the module is to say of where its instructions come from. More of it is more of the compiler that may
// fail.
enum class Places { scopes, lines, none };

// Once per process, before translate(): the compiler's own tables.
void prepare_translation();
// The whole text, else the text without those functions, of its own or of included files, that do not
// compile.
Translated translate(const Source& source, Places places = Places::scopes);

// "'a', 'b' are no files of the shader's own folder".
std::string no_files(const std::vector<std::string>& names, const Source& source);

}  // namespace brdf::shader
