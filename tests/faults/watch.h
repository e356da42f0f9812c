// The state that the parts of the preloaded library share: which call must fail, and how it is reported.
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

// Address ranges of the program and of some libraries in memory.
extern Range program, standard_library, c_library, self;
extern std::uintptr_t program_base;
// True while this library itself is at work. Its own calls are then not counted.
extern thread_local bool inside;

// Returns the function that this library replaces.
template <class Function>
Function next(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

// Returns whether calls of this kind are counted now.
bool wanted(const char* kind);
// Counts a call and returns whether it is the call that must fail.
bool is_due();
// Appends a line to the report.
void report(const char* word, const char* what);

}  // namespace faults
