// From a shader's text to SPIR-V, by glslang, in a process of its own: whatever a text does to the compiler, it ends there.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "shader/front/glslang.h"

namespace brdf::shader {

struct Compiled {
  std::vector<std::uint32_t> spirv;
  std::vector<std::string> notes;  // what was done to the text so that it compiles, in sentences
  std::vector<LeftOut> left_out;   // functions that do not compile
};

// Throws InputError with the compiler's first messages, "FILE:LINE: ...", or where it needs more than its share of memory (1 GiB)
// or time (4 s of the processor); EnvironmentError where no process can be started.
Compiled compile(const Source& source);

// The same of many texts, in one process for all of them: what a process costs is paid once. A text that ends it has a new one follow.
class Compiler {
 public:
  Compiler() = default;
  ~Compiler() { stop(); }
  Compiler(const Compiler&) = delete;
  Compiler& operator=(const Compiler&) = delete;
  Compiled compile(const Source& source);

 private:
  void start();
  void stop();

  int process_ = 0, to_ = -1, from_ = -1;
};

}  // namespace brdf::shader
