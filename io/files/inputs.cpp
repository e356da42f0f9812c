#include "io/files/inputs.h"

#include <sys/stat.h>

#include <atomic>
#include <mutex>
#include <optional>
#include <set>
#include <utility>

namespace brdf::io {
namespace {

using FileNumber = std::pair<dev_t, ino_t>;

std::optional<FileNumber> number_of(const std::filesystem::path& path) {
  struct stat status;
  if (::stat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
  return FileNumber{status.st_dev, status.st_ino};
}

std::atomic<bool> keeps_inputs = false;
std::mutex mutex;
std::set<FileNumber>& inputs() {
  static std::set<FileNumber> all;
  return all;
}

}  // namespace

void keep_inputs() {
  keeps_inputs = true;
}

void note_input(const std::filesystem::path& path) {
  if (!keeps_inputs) return;
  const std::optional<FileNumber> number = number_of(path);
  if (!number) return;
  const std::lock_guard lock(mutex);
  inputs().insert(*number);
}

bool is_kept_input(const std::filesystem::path& path) {
  if (!keeps_inputs) return false;
  const std::optional<FileNumber> number = number_of(path);
  const std::lock_guard lock(mutex);
  return number && inputs().contains(*number);
}

}  // namespace brdf::io
