// Temporary files and folders, from which outputs are made.
#pragma once

#include <sys/stat.h>

#include <filesystem>

#include "io/files/leftovers.h"

namespace brdf::io {

// An entry TARGET.PROCESS.NUMBER.tmp in the folder of its target, locked while this process lives. The
// destructor, or a signal, removes the entry with its content. Entries of the same target that a killed
// process left behind are removed first. Throws the exceptions of cannot_write() of io/files/output.h.
// `shown` is the name that messages use.
class Temporary {
 public:
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;

  const std::filesystem::path& path() const { return path_; }

 protected:
  // Creates and opens the entry. Returns -1 and sets errno on failure.
  using Make = int (*)(const char* path);
  Temporary(const std::filesystem::path& target, const std::filesystem::path& shown, Make make);
  ~Temporary();

  std::filesystem::path path_, shown_;
  int descriptor_ = -1;
  Listed listed_;
};

// The file that receives an output before it replaces the target. Takes over the permissions and the owner
// of the file that it replaces, if `replaced` is not null.
class TemporaryFile : public Temporary {
 public:
  TemporaryFile(const std::filesystem::path& target, const struct stat* replaced,
                const std::filesystem::path& shown);

  int descriptor() const { return descriptor_; }
  // Flushes the file to the disk and renames it to `target`. Throws the exceptions of cannot_write() and
  // broke_off().
  void rename_to(const std::filesystem::path& target);
};

// A folder brdf.PROCESS.NUMBER.tmp in `above`, by default the system's folder for temporary files. `above`
// is created if it is missing.
class TemporaryFolder : public Temporary {
 public:
  explicit TemporaryFolder(const std::filesystem::path& above = std::filesystem::temp_directory_path());
};

}  // namespace brdf::io
