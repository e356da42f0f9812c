#include "io/temporary.h"

#include <dirent.h>
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>

#include "io/error.h"
#include "io/output.h"

namespace brdf::io {
namespace {

namespace fs = std::filesystem;

constexpr std::array kEnding{SIGHUP, SIGINT, SIGQUIT, SIGPIPE, SIGTERM, SIGXCPU};

// What a signal must remove. Names are held in place, because a handler may not allocate.
constexpr std::size_t kMost = 64;
std::array<std::array<char, 4096>, kMost> listed;
std::array<std::atomic<bool>, kMost> taken;
std::atomic_flag busy;

// Keeps a handler from running between what happens to a file and what is said of it in the list: in this thread
// signals wait, in another one the handler does.
class Undisturbed {
 public:
  Undisturbed() {
    sigset_t ending;
    sigemptyset(&ending);
    for (const int signal : kEnding) sigaddset(&ending, signal);
    pthread_sigmask(SIG_BLOCK, &ending, &before_);
    while (busy.test_and_set(std::memory_order_acquire)) {
    }
  }
  Undisturbed(const Undisturbed&) = delete;
  Undisturbed& operator=(const Undisturbed&) = delete;
  ~Undisturbed() {
    busy.clear(std::memory_order_release);
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }

 private:
  sigset_t before_;
};

extern "C" void end_without_temporaries(int signal) {
  while (busy.test_and_set(std::memory_order_acquire)) {
  }
  for (const auto& name : listed)
    if (name[0] != '\0') ::unlink(name.data());
  std::signal(signal, SIG_DFL);
  std::raise(signal);  // held back until this returns; `busy` stays set, so nothing is created meanwhile
}

std::size_t free_place() {
  for (std::size_t k = 0; k < kMost; ++k)
    if (bool no = false; taken[k].compare_exchange_strong(no, true)) return k;
  throw EnvironmentError("more than " + std::to_string(kMost) + " files are written at the same time");
}

// What all temporaries of a target begin with; a name has at most 255 bytes.
std::string beginning(const fs::path& target) {
  return target.filename().string().substr(0, 200) + ".";
}

// A temporary of this target by its name: BEGINNING PROCESS . NUMBER .tmp
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

// Removes the temporaries that no process holds any more.
void sweep(const fs::path& target) {
  const std::string begins = beginning(target);
  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  // Not directory_iterator: it ends the program where it lacks memory.
  DIR* const entries = ::opendir(folder.c_str());
  if (!entries) return;
  const int at = ::dirfd(entries);
  while (const dirent* entry = ::readdir(entries)) {
    if (!is_temporary(entry->d_name, begins)) continue;
    const int file = ::openat(at, entry->d_name, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC);
    if (file < 0) continue;
    struct stat status;
    if (::fstat(file, &status) == 0 && S_ISREG(status.st_mode) && ::flock(file, LOCK_EX | LOCK_NB) == 0)
      ::unlinkat(at, entry->d_name, 0);
    ::close(file);
  }
  ::closedir(entries);
}

}  // namespace

Temporary::Temporary(const fs::path& target, const struct stat* replaced, const fs::path& shown)
    : shown_(shown), place_(free_place()) {
  try {
    sweep(target);
    create(target);
    if (replaced) take_over(*replaced);
  } catch (...) {
    forget();
    throw;
  }
}

void Temporary::create(const fs::path& target) {
  static std::atomic<unsigned> counter = 0;  // two threads may write beside each other
  while (descriptor_ < 0) {
    path_ = (target.parent_path() / beginning(target)).string() + std::to_string(::getpid()) + "." +
            std::to_string(counter++) + ".tmp";
    if (path_.size() >= listed[place_].size()) cannot_write(shown_, ENAMETOOLONG);
    int error = 0;
    {
      const Undisturbed undisturbed;
      std::copy_n(path_.c_str(), path_.size() + 1, listed[place_].begin());
      descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      error = errno;
      if (descriptor_ < 0) listed[place_][0] = '\0';
    }
    if (descriptor_ < 0 && error == EEXIST) continue;  // another machine's, or another's that had our number
    if (descriptor_ < 0) cannot_write(shown_, error);
    // The lock tells others that we live. One that swept just before it was locked took the file away.
    struct stat status;
    if (::flock(descriptor_, LOCK_EX) == 0 && ::fstat(descriptor_, &status) == 0 && status.st_nlink == 0) {
      ::close(descriptor_);
      descriptor_ = -1;
    }
  }
}

// Who may not give a file away keeps it; permissions come last, because a change of owner takes some of them.
void Temporary::take_over(const struct stat& replaced) {
  if (::fchown(descriptor_, replaced.st_uid, replaced.st_gid) != 0) (void)0;
  ::fchmod(descriptor_, replaced.st_mode & 0777);
}

Temporary::~Temporary() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (listed[place_][0] != '\0') {
    const Undisturbed undisturbed;
    ::unlink(listed[place_].data());
  }
  forget();
}

void Temporary::forget() {
  listed[place_][0] = '\0';
  taken[place_] = false;
}

void Temporary::rename_to(const fs::path& target) {
  // A file system without a disk has nothing to wait for.
  if (::fsync(descriptor_) != 0 && errno != EINVAL && errno != ENOTSUP) broke_off(shown_, errno);
  // Not closed before: the lock tells others that the file is not to be swept.
  int error = 0;
  {
    const Undisturbed undisturbed;
    if (::rename(path_.c_str(), target.c_str()) == 0)
      listed[place_][0] = '\0';
    else
      error = errno;
  }
  if (error != 0) cannot_write(shown_, error);
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
  std::signal(SIGXFSZ, SIG_IGN);  // the write fails instead
}

}  // namespace brdf::io
