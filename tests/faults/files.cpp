// Replaces the calls on files in FAULTS_FOLDER.
#include <fcntl.h>
#include <sys/mman.h>
#include <sys/uio.h>
#include <unistd.h>

#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "watch.h"

namespace faults {
namespace {

bool in_folder(const char* path) {
  static const char* const folder = std::getenv("FAULTS_FOLDER");
  const std::size_t size = folder ? std::strlen(folder) : 0;
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

// Counts this call and returns whether it is the call that must fail. If so, the path is reported.
bool is_due_on(const char* path) {
  if (!is_due()) return false;
  inside = true;
  report("failed", path);
  inside = false;
  return true;
}

bool fails(const char* name, const char* path) {
  return wanted(name) && names_watched(path) && is_due_on(path);
}
bool fails(const char* name, int file) {
  char path[PATH_MAX];
  return wanted(name) && is_watched(file, path) && is_due_on(path);
}

// Lengthens the time during which a signal can meet a half-written file.
void wait_with(int file, unsigned milliseconds) {
  char path[PATH_MAX];
  if (wanted("slow") && is_watched(file, path)) usleep(1000 * milliseconds);
}

}  // namespace
}  // namespace faults

using faults::fails;
using faults::next;
using faults::wait_with;

extern "C" {

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
