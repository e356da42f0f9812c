// Tests over every form, scene or table take a few of them in ./test and all in ./test --full, which sets BRDF_THOROUGH.
#pragma once

#include <cstdlib>

namespace brdf {

inline bool thorough() {
  return std::getenv("BRDF_THOROUGH") != nullptr;
}

}  // namespace brdf
