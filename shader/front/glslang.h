// The compiler itself, in this process.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "shader/front/source.h"

namespace brdf::shader {

struct Translated {
  std::vector<std::uint32_t> spirv;  // empty: `messages` say why
  std::string note, messages;
};

// Once per process, before translate(): the compiler's own tables.
void prepare_translation();
Translated translate(const Source& source);

}  // namespace brdf::shader
