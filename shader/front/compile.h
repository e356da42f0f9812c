// Compiles a shader's text to SPIR-V with glslang, in a separate process, so that a crash of the compiler
// does not affect this process.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "shader/front/glslang.h"

namespace brdf::shader {

struct Compiled {
  std::vector<std::uint32_t> spirv;
  std::vector<std::string> notes;        // changes made to the text so that it compiles, as sentences
  std::vector<LeftOut> left_out;         // functions that do not compile
  std::vector<std::string> missing;      // names of includes without a file, in quotes
  std::vector<std::string> asked;        // macros that the text tests but nothing defines
  std::vector<std::string> unmentioned;  // macros of the command line that no file mentions
  std::string narrow_word;               // a type of 16 bits in the text: mediump, lowp, half, min16float
  bool ignores_narrow = false;           // such types were compiled as types of 32 bits
  std::string whole;                     // the text with its includes, macros replaced, comments removed
};

// A function that compiles a text inside the separate process.
using Translate = Translated (*)(const Source&, Places);
// Compiles one text. `by` is the function that runs in the separate process. Throws InputError with the
// compiler's first message, "FILE:LINE: ...". Also throws InputError if the compiler needs more than its
// limit of memory (1 GiB) or processor time (4 s), or if it crashes even without information on source
// lines. Throws EnvironmentError if no process can be started.
Compiled compile(const Source& source, Translate by = translate);

// Compiles many texts in one process, so that the process is started only once. If a text ends the process,
// the next text starts a new one. Throws the same errors as the function compile().
class Compiler {
 public:
  Compiler() = default;
  ~Compiler() { stop(); }
  Compiler(const Compiler&) = delete;
  Compiler& operator=(const Compiler&) = delete;
  Compiled compile(const Source& source);

 private:
  void start();
  int stop();

  int process_ = 0, to_ = -1, from_ = -1;
};

}  // namespace brdf::shader
