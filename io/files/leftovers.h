// What temporaries are called, what a signal removes of them, and what the next run sweeps. For
// io/files/temporary.h.
#pragma once

#include <csignal>
#include <filesystem>
#include <string>

namespace brdf::io {

// The name of a file or a folder in the list of what a signal removes; none while it is empty. Throws
// EnvironmentError where the list is full.
class Listed {
 public:
  Listed();
  Listed(const Listed&) = delete;
  Listed& operator=(const Listed&) = delete;
  ~Listed();

  // False where the name is too long to be held.
  bool set(const std::string& path);
  void clear();
  // Removes what it names, a folder with everything in it, and forgets it. Not in a child that was forked
  // meanwhile.
  void remove();

 private:
  std::size_t place_;
};

// Keeps a handler from running between what happens to a file and what is said of it in the list: in this
// thread signals wait, in another one the handler does.
class Undisturbed {
 public:
  Undisturbed();
  Undisturbed(const Undisturbed&) = delete;
  Undisturbed& operator=(const Undisturbed&) = delete;
  ~Undisturbed();

 private:
  sigset_t before_;
};

// TARGET.PROCESS.NUMBER.tmp beside the target, another one every time.
std::filesystem::path temporary_name(const std::filesystem::path& target);
// Removes the temporaries of this target, files and folders, that no process holds any more.
void sweep(const std::filesystem::path& target);
// Whether an open temporary is locked now and still there: the lock tells others that we live, and one that
// swept just before took it away.
bool is_held(int descriptor);
// From now on signals that end the process remove its temporaries first, then end it as they would have.
// Signals that the process was told to ignore stay ignored; so does the one for files that grow too large,
// whose error is reported. For programs, not for libraries: main calls it.
void remove_temporaries_on_signals();

}  // namespace brdf::io
