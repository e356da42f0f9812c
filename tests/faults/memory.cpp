// Counts the allocations of the program itself and makes one of them fail.
#include "memory.h"

#include <execinfo.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>

#include "watch.h"

extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
}

namespace faults {
namespace {

struct Foreign {
  Range range;
  char name[80];
};
Foreign* foreign = nullptr;
std::size_t foreign_count = 0;

void read_foreign() {
  const char* path = std::getenv("FAULTS_FOREIGN");
  std::FILE* file = path ? std::fopen(path, "r") : nullptr;
  if (!file) return;
  constexpr std::size_t kMost = 200000;
  foreign = static_cast<Foreign*>(__libc_malloc(kMost * sizeof(Foreign)));
  unsigned long first = 0, last = 0;
  while (foreign_count < kMost &&
         std::fscanf(file, "%lx %lx %79s", &first, &last, foreign[foreign_count].name) == 3)
    foreign[foreign_count++].range = {first, last};
  std::fclose(file);
}

// Returns the name of the function if it is in the program but is not the program's own code, otherwise
// null.
const char* foreign_name(const void* address) {
  const void* const at =
      reinterpret_cast<const void*>(reinterpret_cast<std::uintptr_t>(address) - program_base);
  for (std::size_t k = 0; k < foreign_count; ++k)
    if (foreign[k].range.holds(at)) return foreign[k].name;
  return nullptr;
}

// The iterators over folders in the C++ library are declared not to throw internally. They end the program
// if they get no memory.
bool iterates_a_folder(const void* frame) {
  Dl_info at;
  return standard_library.holds(frame) && dladdr(frame, &at) != 0 && at.dli_sname &&
         std::strstr(at.dli_sname, "directory_iterator");
}

// Returns null if the program's own code requests the memory, otherwise the name of a library or of foreign
// code in the program.
const char* who_asks() {
  static thread_local char name[128];
  void* frames[64];
  const int count = backtrace(frames, 64);
  bool own = false;
  for (int k = 0; k < count; ++k) {
    if (!own && iterates_a_folder(frames[k])) return "directory_iterator";
    if (self.holds(frames[k]) || standard_library.holds(frames[k]) || c_library.holds(frames[k])) continue;
    if (program.holds(frames[k])) {
      const char* its = foreign_name(frames[k]);
      if (its && std::strcmp(its, "-") != 0) {
        if (!own) return its;
        continue;  // it calls back into the program
      }
      own = own || !its;  // a template of the C++ library belongs to its caller: the next frames decide
      continue;
    }
    if (own) continue;  // a library that calls back into the program
    Dl_info module;
    if (dladdr(frames[k], &module) == 0 || !module.dli_fname) return "unknown";
    const char* slash = std::strrchr(module.dli_fname, '/');
    std::snprintf(name, sizeof name, "%s", slash ? slash + 1 : module.dli_fname);
    return name;
  }
  return nullptr;
}

void report_stack() {
  void* frames[40];
  const int count = backtrace(frames, 40);
  for (int k = 0; k < count; ++k) {
    char text[32];
    if (!program.holds(frames[k])) continue;
    std::snprintf(text, sizeof text, "%lx", reinterpret_cast<std::uintptr_t>(frames[k]) - program_base);
    report("frame", text);
  }
}

void* allocate(std::size_t size, std::size_t alignment, const void* caller) {
  if (wanted("memory") && (program.holds(caller) || standard_library.holds(caller)) && is_due()) {
    inside = true;
    const char* other = who_asks();
    report(other ? "foreign" : "failed", other ? other : "memory");
    if (!other) report_stack();
    inside = false;
    if (!other) return nullptr;
  }
  return alignment ? __libc_memalign(alignment, size) : __libc_malloc(size);
}

void* allocate_or_throw(std::size_t size, std::size_t alignment, const void* caller) {
  void* block = allocate(size ? size : 1, alignment, caller);
  if (!block) throw std::bad_alloc();
  return block;
}

}  // namespace

void prepare_stacks() {
  read_foreign();
  void* frames[4];
  backtrace(frames, 4);  // the first call loads a library
}

}  // namespace faults

using faults::allocate;
using faults::allocate_or_throw;

#define CALLER __builtin_return_address(0)

void* operator new(std::size_t size) {
  return allocate_or_throw(size, 0, CALLER);
}
void* operator new[](std::size_t size) {
  return allocate_or_throw(size, 0, CALLER);
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return allocate(size, 0, CALLER);
}
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept {
  return allocate(size, 0, CALLER);
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  return allocate_or_throw(size, std::size_t(alignment), CALLER);
}
void* operator new[](std::size_t size, std::align_val_t alignment) {
  return allocate_or_throw(size, std::size_t(alignment), CALLER);
}
void operator delete(void* block) noexcept {
  std::free(block);
}
void operator delete[](void* block) noexcept {
  std::free(block);
}
void operator delete(void* block, std::size_t) noexcept {
  std::free(block);
}
void operator delete[](void* block, std::size_t) noexcept {
  std::free(block);
}
void operator delete(void* block, std::align_val_t) noexcept {
  std::free(block);
}
void operator delete[](void* block, std::align_val_t) noexcept {
  std::free(block);
}
void operator delete(void* block, std::size_t, std::align_val_t) noexcept {
  std::free(block);
}
void operator delete[](void* block, std::size_t, std::align_val_t) noexcept {
  std::free(block);
}

extern "C" void* malloc(std::size_t size) {
  if (!faults::program.holds(CALLER)) return __libc_malloc(size);
  void* block = allocate(size, 0, CALLER);
  if (!block) errno = ENOMEM;
  return block;
}
