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
  bool is_declaration = false;
};

struct Translated {
  std::vector<std::uint32_t> spirv;  // empty: `messages` say why
  std::string note, messages;
  std::uint32_t line = 0;              // of the first message; 0: elsewhere than in this file
  std::vector<LeftOut> left_out = {};  // what the rest was compiled without
};

// Once per process, before translate(): the compiler's own tables.
void prepare_translation();
// The whole text, else the text without those functions that do not compile.
Translated translate(const Source& source);

}  // namespace brdf::shader
