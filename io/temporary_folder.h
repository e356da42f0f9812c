// A folder for what is made on the way.
#pragma once

#include <filesystem>

namespace brdf::io {

// Has a name of its own in `above` (which is made where it is not there; the system's folder for such things unless one is
// named), and is removed with everything in it. What a killed process leaves does no harm. Throws as cannot_write() of
// io/output.h.
class TemporaryFolder {
 public:
  explicit TemporaryFolder(const std::filesystem::path& above = std::filesystem::temp_directory_path());
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder();

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace brdf::io
