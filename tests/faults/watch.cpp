// This library is preloaded before a program. It makes the n-th call of one kind fail while main() runs, or
// counts the calls.
//
//   FAULTS_KIND     open, read, write, short, interrupted, fsync, rename, mmap, close (of files in
//                   FAULTS_FOLDER), or memory. slow: no call fails, but writing takes longer.
//   FAULTS_AT       number of the call that fails, from 1; 0: no call fails
//   FAULTS_FOLDER   absolute path
//   FAULTS_FOREIGN  file with the functions in the program that are not its own code: lines
//                   "FIRST LAST NAME", addresses in hex. The name "-" marks the C++ library; its
//                   calls belong to their caller.
//   FAULTS_REPORT   file that is written: "calls N" at the end, "failed WHAT" or "foreign NAME" when
//                   the call is due
//
// "memory" means the allocations of the program itself: allocations that its own code requests, directly or
// through the C++ library.
#include "watch.h"

#include <fcntl.h>
#include <link.h>
#include <unistd.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "memory.h"

namespace faults {

Range program, standard_library, c_library, self;
std::uintptr_t program_base = 0;
thread_local bool inside = false;

namespace {

const char *kind = "", *report_file = nullptr;
long due = 0;
std::atomic<long> calls{0};
std::atomic<bool> armed{false};
int (*real_main)(int, char**, char**) = nullptr;

int find_modules(dl_phdr_info* module, std::size_t, void*) {
  Range all{UINTPTR_MAX, 0};
  for (int k = 0; k < module->dlpi_phnum; ++k) {
    const auto& part = module->dlpi_phdr[k];
    if (part.p_type != PT_LOAD) continue;
    const std::uintptr_t begin = module->dlpi_addr + part.p_vaddr;
    if (begin < all.first) all.first = begin;
    if (begin + part.p_memsz > all.last) all.last = begin + part.p_memsz;
  }
  if (module->dlpi_name[0] == '\0') {
    if (program.last == 0) program = all, program_base = module->dlpi_addr;
  } else if (std::strstr(module->dlpi_name, "/libstdc++.so")) {
    standard_library = all;
  } else if (std::strstr(module->dlpi_name, "/libc.so")) {
    c_library = all;
  } else if (all.holds(reinterpret_cast<const void*>(&find_modules))) {
    self = all;
  }
  return 0;
}

int watched_main(int argc, char** argv, char** environment) {
  kind = std::getenv("FAULTS_KIND") ? std::getenv("FAULTS_KIND") : "";
  report_file = std::getenv("FAULTS_REPORT");
  if (const char* at = std::getenv("FAULTS_AT")) due = std::atol(at);
  dl_iterate_phdr(find_modules, nullptr);
  prepare_stacks();
  armed = true;
  const int code = real_main(argc, argv, environment);
  armed = false;
  char text[32];
  std::snprintf(text, sizeof text, "%ld", calls.load());
  report("calls", text);
  return code;
}

}  // namespace

void report(const char* word, const char* what) {
  if (!report_file) return;
  static const auto real_open = next<int (*)(const char*, int, ...)>("open");
  static const auto real_write = next<ssize_t (*)(int, const void*, std::size_t)>("write");
  static const auto real_close = next<int (*)(int)>("close");
  char line[PATH_MAX + 64];
  const int size = std::snprintf(line, sizeof line, "%s %s\n", word, what);
  const int file = real_open(report_file, O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (file < 0) return;
  if (real_write(file, line, std::size_t(size)) < 0) std::abort();
  real_close(file);
}

bool wanted(const char* name) {
  return armed.load(std::memory_order_relaxed) && !inside && std::strcmp(kind, name) == 0;
}

bool is_due() {
  return ++calls == due;
}

}  // namespace faults

extern "C" int __libc_start_main(int (*main)(int, char**, char**), int argc, char** argv, void (*init)(),
                                 void (*fini)(), void (*loader)(), void* stack) {
  faults::real_main = main;
  const auto real = faults::next<decltype(&__libc_start_main)>("__libc_start_main");
  return real(faults::watched_main, argc, argv, init, fini, loader, stack);
}
