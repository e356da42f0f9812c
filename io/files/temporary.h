// The file under another name that an output is written to before it takes its place.
#pragma once

#include <sys/stat.h>

#include <filesystem>
#include <string>

#include "io/files/leftovers.h"

namespace brdf::io {

// Created beside its target, as TARGET.PROCESS.NUMBER.tmp, and locked while it is written; with the
// permissions and the owner of what it replaces. Removed unless it was renamed, also by a signal; what a
// killed process left of the same target is removed first. Throws as cannot_write() and broke_off() of
// io/files/output.h; `shown` is what messages call the target.
class Temporary {
 public:
  Temporary(const std::filesystem::path& target, const struct stat* replaced,
            const std::filesystem::path& shown);
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;
  ~Temporary();

  int descriptor() const { return descriptor_; }
  // Makes it the target, whole and on the disk.
  void rename_to(const std::filesystem::path& target);

 private:
  void create(const std::filesystem::path& target);
  void take_over(const struct stat& replaced);

  std::string path_;
  std::filesystem::path shown_;
  int descriptor_ = -1;
  Listed listed_;
};

}  // namespace brdf::io
