// From a shader's text to SPIR-V, by glslang, in a process of its own: whatever a text does to the compiler, it ends there.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "shader/front/source.h"

namespace brdf::shader {

struct Compiled {
  std::vector<std::uint32_t> spirv;
  std::vector<std::string> notes;  // what was done to the text so that it compiles, in sentences
};

// Throws InputError with the compiler's first messages, "FILE:LINE: ...", or where it needs more than its share of memory (1 GiB)
// or time (4 s of the processor); EnvironmentError where no process can be started.
Compiled compile(const Source& source);

}  // namespace brdf::shader
