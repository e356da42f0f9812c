// Preloaded before a program: makes the n-th call of one kind fail while main() runs, or counts the calls.
//
//   FAULTS_KIND    open, write, short, interrupted, fsync, rename, mmap, close (of files in FAULTS_FOLDER), or memory
//                  slow: none fails, writing takes its time
//   FAULTS_AT      which call fails, from 1; 0: none
//   FAULTS_FOLDER  absolute path
//   FAULTS_FOREIGN names of functions in the program that are not its own: lines "FIRST LAST NAME", addresses in hex;
//                  the name "-" is the C++ library's, which is whose use it is
//   FAULTS_REPORT  file that is written: "calls N" at the end, "failed WHAT" or "foreign NAME" when it is due
//
// "memory" are the allocations of the program itself: those that its own code asks for, also through the C++ library.
#include <dlfcn.h>
#include <execinfo.h>
#include <fcntl.h>
#include <link.h>
#include <sys/mman.h>
#include <sys/uio.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <climits>
#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>

extern "C" {
void* __libc_malloc(std::size_t size);
void* __libc_calloc(std::size_t count, std::size_t size);
void* __libc_realloc(void* block, std::size_t size);
void* __libc_memalign(std::size_t alignment, std::size_t size);
}

namespace {

struct Range {
  std::uintptr_t first, last;
  bool holds(const void* address) const {
    const auto at = reinterpret_cast<std::uintptr_t>(address);
    return at >= first && at < last;
  }
};
struct Foreign {
  Range range;
  char name[80];
};

// Nothing here may allocate: the allocations are watched.
const char *kind = "", *report_file = nullptr;
char folder[PATH_MAX];
long due = 0;
std::atomic<long> calls{0};
std::atomic<bool> armed{false};
Range program{0, 0}, standard_library{0, 0}, c_library{0, 0}, self{0, 0};
std::uintptr_t program_base = 0;
Foreign* foreign = nullptr;
std::size_t foreign_count = 0;
thread_local bool inside = false;

template <class Function>
Function next(const char* name) {
  return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

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

// The name of the function if it is in the program but not its own.
const char* foreign_name(const void* address) {
  const void* const at =
      reinterpret_cast<const void*>(reinterpret_cast<std::uintptr_t>(address) - program_base);
  for (std::size_t k = 0; k < foreign_count; ++k)
    if (foreign[k].range.holds(at)) return foreign[k].name;
  return nullptr;
}

// Who asks for memory: null for the program's own code, else the name of a library or of foreign code in the program.
const char* who_asks() {
  static thread_local char name[128];
  void* frames[64];
  const int count = backtrace(frames, 64);
  bool own = false;
  for (int k = 0; k < count; ++k) {
    if (self.holds(frames[k]) || standard_library.holds(frames[k]) || c_library.holds(frames[k])) continue;
    if (program.holds(frames[k])) {
      const char* its = foreign_name(frames[k]);
      if (its && std::strcmp(its, "-") != 0) {
        if (!own) return its;
        continue;  // it calls us back
      }
      own = own || !its;  // a template of the C++ library belongs to who uses it: the next frames decide
      continue;
    }
    if (own) continue;  // a library that calls us back
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

bool wanted(const char* name) {
  return armed.load(std::memory_order_relaxed) && !inside && std::strcmp(kind, name) == 0;
}

// Counts a call; whether it is the one that fails.
bool is_due(const char* what) {
  if (++calls != due) return false;
  inside = true;
  report("failed", what);
  inside = false;
  return true;
}

bool in_folder(const char* path) {
  const std::size_t size = std::strlen(folder);
  return size > 0 && std::strncmp(path, folder, size) == 0 && (path[size] == '/' || path[size] == '\0');
}

bool names_watched(const char* path) {
  if (path[0] == '/') return in_folder(path);
  char here[PATH_MAX];
  return getcwd(here, sizeof here) && in_folder(here);
}

bool is_watched(int file, char* path) {
  char link[64];
  std::snprintf(link, sizeof link, "/proc/self/fd/%d", file);
  const ssize_t size = readlink(link, path, PATH_MAX - 1);
  if (size < 0) return false;
  path[size] = '\0';
  return in_folder(path);
}

bool fails(const char* name, const char* path) {
  return wanted(name) && names_watched(path) && is_due(path);
}
bool fails(const char* name, int file) {
  char path[PATH_MAX];
  return wanted(name) && is_watched(file, path) && is_due(path);
}

// Makes the moment long in which a signal meets a file half written.
void wait_with(int file, unsigned milliseconds) {
  char path[PATH_MAX];
  if (wanted("slow") && is_watched(file, path)) usleep(1000 * milliseconds);
}

void* allocate(std::size_t size, std::size_t alignment, const void* caller) {
  if (wanted("memory") && (program.holds(caller) || standard_library.holds(caller)) && ++calls == due) {
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

int (*real_main)(int, char**, char**) = nullptr;

int watched_main(int argc, char** argv, char** environment) {
  kind = std::getenv("FAULTS_KIND") ? std::getenv("FAULTS_KIND") : "";
  report_file = std::getenv("FAULTS_REPORT");
  if (const char* at = std::getenv("FAULTS_AT")) due = std::atol(at);
  if (const char* where = std::getenv("FAULTS_FOLDER")) std::snprintf(folder, sizeof folder, "%s", where);
  dl_iterate_phdr(find_modules, nullptr);
  read_foreign();
  void* frames[4];
  backtrace(frames, 4);  // the first one loads a library
  armed = true;
  const int code = real_main(argc, argv, environment);
  armed = false;
  char text[32];
  std::snprintf(text, sizeof text, "%ld", calls.load());
  report("calls", text);
  return code;
}

}  // namespace

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

extern "C" {

int __libc_start_main(int (*main)(int, char**, char**), int argc, char** argv, void (*init)(), void (*fini)(),
                      void (*loader)(), void* stack) {
  real_main = main;
  const auto real = next<decltype(&__libc_start_main)>("__libc_start_main");
  return real(watched_main, argc, argv, init, fini, loader, stack);
}

void* malloc(std::size_t size) {
  if (!program.holds(CALLER)) return __libc_malloc(size);
  void* block = allocate(size, 0, CALLER);
  if (!block) errno = ENOMEM;
  return block;
}

#define OPEN(NAME)                                                                \
  int NAME(const char* path, int flags, ...) {                                    \
    va_list rest;                                                                 \
    va_start(rest, flags);                                                        \
    const mode_t mode = flags & (O_CREAT | O_TMPFILE) ? va_arg(rest, mode_t) : 0; \
    va_end(rest);                                                                 \
    if (fails("open", path)) return errno = flags & O_CREAT ? ENOSPC : EIO, -1;   \
    static const auto real = next<int (*)(const char*, int, ...)>(#NAME);         \
    return real(path, flags, mode);                                               \
  }
OPEN(open)
OPEN(open64)

#define OPENAT(NAME)                                                              \
  int NAME(int at, const char* path, int flags, ...) {                            \
    va_list rest;                                                                 \
    va_start(rest, flags);                                                        \
    const mode_t mode = flags & (O_CREAT | O_TMPFILE) ? va_arg(rest, mode_t) : 0; \
    va_end(rest);                                                                 \
    if (fails("open", path)) return errno = flags & O_CREAT ? ENOSPC : EIO, -1;   \
    static const auto real = next<int (*)(int, const char*, int, ...)>(#NAME);    \
    return real(at, path, flags, mode);                                           \
  }
OPENAT(openat)
OPENAT(openat64)

#define FOPEN(NAME)                                                                 \
  std::FILE* NAME(const char* path, const char* mode) {                             \
    if (fails("open", path)) return errno = mode[0] == 'r' ? EIO : ENOSPC, nullptr; \
    static const auto real = next<std::FILE* (*)(const char*, const char*)>(#NAME); \
    return real(path, mode);                                                        \
  }
FOPEN(fopen)
FOPEN(fopen64)

ssize_t write(int file, const void* data, std::size_t size) {
  static const auto real = next<decltype(&write)>("write");
  wait_with(file, 1);
  if (fails("write", file)) return errno = ENOSPC, -1;
  if (fails("interrupted", file)) return errno = EINTR, -1;
  if (fails("short", file)) return real(file, data, (size + 1) / 2);
  return real(file, data, size);
}

ssize_t writev(int file, const iovec* parts, int count) {
  static const auto real = next<decltype(&writev)>("writev");
  if (fails("write", file)) return errno = ENOSPC, -1;
  if (fails("interrupted", file)) return errno = EINTR, -1;
  if (fails("short", file)) return real(file, parts, 1);
  return real(file, parts, count);
}

ssize_t read(int file, void* data, std::size_t size) {
  static const auto real = next<decltype(&read)>("read");
  if (fails("read", file)) return errno = EIO, -1;
  return real(file, data, size);
}

int fsync(int file) {
  static const auto real = next<decltype(&fsync)>("fsync");
  wait_with(file, 10);
  if (fails("fsync", file)) return errno = EIO, -1;
  return real(file);
}

int close(int file) {
  static const auto real = next<decltype(&close)>("close");
  const bool failing = fails("close", file);
  const int result = real(file);
  return failing ? errno = EIO, -1 : result;
}

int rename(const char* from, const char* to) {
  static const auto real = next<decltype(&rename)>("rename");
  if (fails("rename", to)) return errno = EIO, -1;
  return real(from, to);
}

#define MMAP(NAME)                                                                             \
  void* NAME(void* at, std::size_t size, int protection, int flags, int file, off_t offset) {  \
    static const auto real = next<void* (*)(void*, std::size_t, int, int, int, off_t)>(#NAME); \
    if (file >= 0 && fails("mmap", file)) return errno = ENOMEM, MAP_FAILED;                   \
    return real(at, size, protection, flags, file, offset);                                    \
  }
MMAP(mmap)
MMAP(mmap64)

}  // extern "C"
