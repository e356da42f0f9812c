#include "io/files/leftovers.h"

#include <dirent.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>

#include "io/files/error.h"

namespace brdf::io {
namespace {

namespace fs = std::filesystem;

constexpr std::array kEnding{SIGHUP, SIGINT, SIGQUIT, SIGPIPE, SIGTERM, SIGXCPU};

// Names are stored in fixed arrays because a signal handler must not allocate. A forked child inherits the
// list of its parent; `owner` identifies the entries of this process.
constexpr std::size_t kPlaces = 64;
struct Name {
  std::array<char, 4096> path;  // empty: no entry
  pid_t owner;

  bool is_ours() const { return path[0] != '\0' && owner == ::getpid(); }
};
std::array<Name, kPlaces> listed;
std::array<std::atomic<bool>, kPlaces> taken;
std::atomic_flag busy;

std::size_t free_place() {
  for (std::size_t k = 0; k < kPlaces; ++k)
    if (bool no = false; taken[k].compare_exchange_strong(no, true)) return k;
  throw EnvironmentError("more than " + std::to_string(kPlaces) + " files would be written at the same time");
}

// Removes a file, or a folder with its content, with functions that a signal handler may call; memory is
// not allocated. Several rounds are made because another process may still add entries to the folder.
void remove_entry(int at, const char* name, int depth = 0) {
  constexpr int kRounds = 3, kDeepest = 8;
  if (::unlinkat(at, name, 0) == 0 || errno != EISDIR || depth == kDeepest) return;
  for (int round = 0; round < kRounds; ++round) {
    const int folder = ::openat(at, name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    if (folder < 0) continue;
    alignas(dirent64) char entries[2048];
    for (ssize_t size = 0;
         (size = ::getdents64(folder, reinterpret_cast<dirent64*>(entries), sizeof entries)) > 0;)
      for (ssize_t k = 0; k < size;) {
        const auto* entry = reinterpret_cast<const dirent64*>(entries + k);
        k += entry->d_reclen;
        if (std::strcmp(entry->d_name, ".") != 0 && std::strcmp(entry->d_name, "..") != 0)
          remove_entry(folder, entry->d_name, depth + 1);
      }
    ::close(folder);
    if (::unlinkat(at, name, AT_REMOVEDIR) == 0) return;
  }
}

extern "C" void end_without_temporaries(int signal) {
  while (busy.test_and_set(std::memory_order_acquire)) {
  }
  for (const Name& name : listed)
    if (name.is_ours()) remove_entry(AT_FDCWD, name.path.data());
  std::signal(signal, SIG_DFL);
  // The signal is blocked until this handler returns. `busy` stays set, so that nothing is created
  // meanwhile.
  std::raise(signal);
}

// The common prefix of all temporaries of a target. The name is cut to 200 bytes because a file's name has
// at most 255.
std::string beginning(const fs::path& target) {
  return target.filename().string().substr(0, 200) + ".";
}

// BEGINNING PROCESS . NUMBER .tmp
bool is_temporary(std::string_view name, std::string_view begins) {
  if (!name.starts_with(begins) || !name.ends_with(".tmp")) return false;
  name.remove_prefix(begins.size());
  name.remove_suffix(4);
  const std::size_t point = name.find('.');
  const auto is_number = [](std::string_view text) {
    return !text.empty() && text.find_first_not_of("0123456789") == text.npos;
  };
  return point != name.npos && is_number(name.substr(0, point)) && is_number(name.substr(point + 1));
}

}  // namespace

Listed::Listed() : place_(free_place()) {}

Listed::~Listed() {
  clear();
  taken[place_] = false;
}

bool Listed::set(const std::string& path) {
  Name& name = listed[place_];
  if (path.size() >= name.path.size()) return false;
  name.owner = ::getpid();
  std::copy_n(path.c_str(), path.size() + 1, name.path.begin());
  return true;
}

void Listed::clear() {
  listed[place_].path[0] = '\0';
}

void Listed::remove() {
  if (!listed[place_].is_ours()) return;
  const Undisturbed undisturbed;
  remove_entry(AT_FDCWD, listed[place_].path.data());
  clear();
}

Undisturbed::Undisturbed() {
  sigset_t ending;
  sigemptyset(&ending);
  for (const int signal : kEnding) sigaddset(&ending, signal);
  pthread_sigmask(SIG_BLOCK, &ending, &before_);
  while (busy.test_and_set(std::memory_order_acquire)) {
  }
}

Undisturbed::~Undisturbed() {
  busy.clear(std::memory_order_release);
  pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

fs::path temporary_name(const fs::path& target) {
  static std::atomic<unsigned> counter = 0;  // two threads may write at the same time
  return (target.parent_path() / beginning(target)).string() + std::to_string(::getpid()) + "." +
         std::to_string(counter++) + ".tmp";
}

void sweep(const fs::path& target) {
  const std::string begins = beginning(target);
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  // Not directory_iterator, which terminates the program if memory runs out.
  DIR* const entries = ::opendir(folder.c_str());
  if (!entries) return;
  const int at = ::dirfd(entries);
  while (const dirent* entry = ::readdir(entries)) {
    if (!is_temporary(entry->d_name, begins)) continue;
    const int file = ::openat(at, entry->d_name, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (file < 0) continue;
    struct stat status;
    if (::fstat(file, &status) == 0 && (S_ISREG(status.st_mode) || S_ISDIR(status.st_mode)) &&
        ::flock(file, LOCK_EX | LOCK_NB) == 0)
      remove_entry(at, entry->d_name);
    ::close(file);
  }
  ::closedir(entries);
}

bool is_held(int descriptor) {
  struct stat status;
  return ::flock(descriptor, LOCK_EX) != 0 || ::fstat(descriptor, &status) != 0 || status.st_nlink > 0;
}

void remove_temporaries_on_signals() {
  struct sigaction action = {};
  action.sa_handler = end_without_temporaries;
  for (const int signal : kEnding) sigaddset(&action.sa_mask, signal);
  for (const int signal : kEnding) {
    struct sigaction before;
    if (::sigaction(signal, nullptr, &before) == 0 && before.sa_handler != SIG_IGN)
      ::sigaction(signal, &action, nullptr);
  }
  std::signal(SIGXFSZ, SIG_IGN);  // the write fails with an error instead
}

}  // namespace brdf::io
