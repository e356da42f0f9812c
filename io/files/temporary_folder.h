// A folder for what is made on the way.
#pragma once

#include <filesystem>

#include "io/files/leftovers.h"

namespace brdf::io {

// Has a name of its own in `above` (which is made where it is not there; the system's folder for such things
// unless one is named), brdf.PROCESS.NUMBER.tmp, and is removed with everything in it, also by a signal
// (io/files/temporary.h); what a killed process left there is removed first. Throws as cannot_write() of
// io/files/output.h.
class TemporaryFolder {
 public:
  explicit TemporaryFolder(const std::filesystem::path& above = std::filesystem::temp_directory_path());
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder();

  const std::filesystem::path& path() const { return path_; }

 private:
  void create(const std::filesystem::path& target);

  std::filesystem::path path_;
  int descriptor_ = -1;  // whose lock tells others that we live
  Listed listed_;
};

}  // namespace brdf::io
