// Names of temporary files and folders, their removal by signals, and the removal of leftovers by the next
// run. Used by io/files/temporary.h.
#pragma once

#include <csignal>
#include <filesystem>
#include <string>

namespace brdf::io {

// An entry in the list of files and folders that a signal removes. An entry without a name removes nothing.
// The constructor throws EnvironmentError if the list is full.
class Listed {
 public:
  Listed();
  Listed(const Listed&) = delete;
  Listed& operator=(const Listed&) = delete;
  ~Listed();

  // Sets the name. Returns false if the name is too long to be stored.
  bool set(const std::string& path);
  void clear();
  // Removes the named file or folder, including the content of the folder, and clears the entry. Does
  // nothing in a child process that was forked after set().
  void remove();

 private:
  std::size_t place_;
};

// Keeps the signal handler from running between a change of a file and the matching change of the list.
// Signals are blocked in this thread; a handler that runs in another thread waits.
class Undisturbed {
 public:
  Undisturbed();
  Undisturbed(const Undisturbed&) = delete;
  Undisturbed& operator=(const Undisturbed&) = delete;
  ~Undisturbed();

 private:
  sigset_t before_;
};

// Returns TARGET.PROCESS.NUMBER.tmp in the folder of the target, a different name on every call. Names of
// more than 200 bytes are shortened.
std::filesystem::path temporary_name(const std::filesystem::path& target);
// Removes the temporary files and folders of this target that no running process holds.
void sweep(const std::filesystem::path& target);
// Locks an open temporary and returns whether its file still exists. The lock shows other processes that
// this one is alive. A process that swept just before the lock was set may have removed the file.
bool is_held(int descriptor);
// Installs handlers for the signals that end the process. They remove the temporaries of the process first
// and then end the process as without a handler. Signals that the process was started to ignore remain
// ignored. The signal for files that grow too large is ignored too, so that the write fails and its error
// is reported. For programs, not for libraries: main calls this function.
void remove_temporaries_on_signals();

}  // namespace brdf::io
