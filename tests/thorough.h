// Tests over every form, scene or table use a few of them in ./test, and all of them in ./test --full,
// which sets BRDF_THOROUGH.
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>

namespace brdf {

inline bool thorough() {
  return std::getenv("BRDF_THOROUGH") != nullptr;
}

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool kSanitized = true;
#else
inline constexpr bool kSanitized = false;
#endif

}  // namespace brdf

// For the beginning of a test that integrates or searches for many seconds when it is sanitized. Such a
// test then runs only in ./test --full.
#define BRDF_LONG_UNDER_SANITIZERS() \
  if (brdf::kSanitized && !brdf::thorough()) GTEST_SKIP() << "sanitized by ./test --full alone"
