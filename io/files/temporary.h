// Files and folders for what is made on the way to an output.
#pragma once

#include <sys/stat.h>

#include <filesystem>
#include <string>

#include "io/files/leftovers.h"

namespace brdf::io {

// An entry TARGET.PROCESS.NUMBER.tmp beside its target, locked while this process lives. It is removed with
// everything in it, also by a signal; what a killed process left of the same target is removed first. Throws
// as cannot_write() of io/files/output.h; `shown` is the name that messages say.
class Temporary {
 public:
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;

  const std::filesystem::path& path() const { return path_; }

 protected:
  // Makes the entry and opens it; -1 and errno where that fails.
  using Make = int (*)(const char* path);
  Temporary(const std::filesystem::path& target, const std::filesystem::path& shown, Make make);
  ~Temporary();

  std::filesystem::path path_, shown_;
  int descriptor_ = -1;
  Listed listed_;
};

// The file under another name that an output is written to before it takes its place, with the permissions
// and the owner of the file that it replaces.
class TemporaryFile : public Temporary {
 public:
  TemporaryFile(const std::filesystem::path& target, const struct stat* replaced,
                const std::filesystem::path& shown);

  int descriptor() const { return descriptor_; }
  // Makes it the target, whole and on the disk. Throws as cannot_write() and broke_off().
  void rename_to(const std::filesystem::path& target);
};

// A folder brdf.PROCESS.NUMBER.tmp in `above`, which is made if it is missing; in the system's folder for
// temporary files unless another is named.
class TemporaryFolder : public Temporary {
 public:
  explicit TemporaryFolder(const std::filesystem::path& above = std::filesystem::temp_directory_path());
};

}  // namespace brdf::io
