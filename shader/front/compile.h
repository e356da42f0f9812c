// From a shader's text to SPIR-V, by glslang, in a process of its own: whatever a text does to the compiler,
// it ends there.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "shader/front/glslang.h"

namespace brdf::shader {

struct Compiled {
  std::vector<std::uint32_t> spirv;
  std::vector<std::string> notes;        // what was done to the text so that it compiles, in sentences
  std::vector<LeftOut> left_out;         // functions that do not compile
  std::vector<std::string> missing;      // included names that no file has, in quotes
  std::vector<std::string> asked;        // macros that the text asks for and that nothing defines
  std::vector<std::string> unmentioned;  // macros of the command line that no file mentions
  std::string whole;                     // the text with its includes, macros replaced, comments gone
};

// Throws InputError with the compiler's first message, "FILE:LINE: ...", or where it needs more than its
// share of memory (1 GiB) or time (4 s of the processor), or crashes, whatever it is told of places;
// EnvironmentError where no process can be started. `by` is what runs in that process.
using Translate = Translated (*)(const Source&, Places);
Compiled compile(const Source& source, Translate by = translate);

// The same of many texts, in one process for all of them: what a process costs is paid once. A text that ends
// it has a new one follow.
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
