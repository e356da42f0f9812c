// What the parts of the preloaded library share: which call is to fail, and what is said of it.
#pragma once

#include <dlfcn.h>
#include <limits.h>

#include <cstdint>

namespace faults {

struct Range {
  std::uintptr_t first = 0, last = 0;
  bool holds(const void* address) const {
    const auto at = reinterpret_cast<std::uintptr_t>(address);
    return at >= first && at < last;
  }
};

// Where the program and some libraries stand in memory.
extern Range program, standard_library, c_library, self;
extern std::uintptr_t program_base;
// Nothing is counted while the library is at work itself: it must not allocate then, or not count it.
extern thread_local bool inside;

// The function that this library stands before.
template <class Function>
Function next(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

// Whether calls of this kind are counted now.
bool wanted(const char* kind);
// Counts a call; whether it is the one that fails.
bool is_due();
// Appends a line to the report.
void report(const char* word, const char* what);

}  // namespace faults
