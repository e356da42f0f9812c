#include "io/output.h"

#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <string>
#include <system_error>

#include "io/error.h"

namespace brdf::io {
namespace {

namespace fs = std::filesystem;

// Removes the temporary file unless it was renamed.
class Temporary {
 public:
  explicit Temporary(const fs::path& target) {
    static std::atomic<unsigned> counter = 0;  // two threads may write beside each other
    path_ = target;
    path_ += "." + std::to_string(::getpid()) + "." + std::to_string(counter++) + ".tmp";
  }
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;
  ~Temporary() {
    std::error_code ignored;
    if (!renamed_) fs::remove(path_, ignored);
  }
  const fs::path& path() const { return path_; }
  void rename_to(const fs::path& target) {
    std::error_code error;
    fs::rename(path_, target, error);
    if (error) throw InputError(target.string() + ": cannot be written: " + error.message());
    renamed_ = true;
  }

 private:
  fs::path path_;
  bool renamed_ = false;
};

void write_stream(const fs::path& shown, const fs::path& path,
                  const std::function<void(std::ostream&)>& write) {
  errno = 0;
  std::ofstream out(path, std::ios::binary | std::ios::trunc);
  if (!out) throw InputError(shown.string() + ": cannot be written: " + std::strerror(errno));
  write(out);
  errno = 0;
  out.close();
  if (!out) throw EnvironmentError(shown.string() + ": writing broke off: " + std::strerror(errno));
}

// The file behind a chain of links, whether it exists or not.
fs::path resolved(fs::path path) {
  constexpr int kMaxLinks = 40;
  std::error_code error;
  for (int k = 0; k < kMaxLinks && fs::is_symlink(path, error); ++k)
    path = path.parent_path() / fs::read_symlink(path, error);
  return path;
}

bool is_special(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  return fs::exists(status) && !fs::is_regular_file(status);
}

}  // namespace

void write_file_atomically(const fs::path& path, std::string_view content) {
  write_file_atomically(path, [&](std::ostream& out) {
    out.write(content.data(), static_cast<std::streamsize>(content.size()));
  });
}

void write_file_atomically(const fs::path& path, const std::function<void(std::ostream&)>& write) {
  if (is_special(path)) return write_stream(path, path, write);
  const fs::path target = resolved(path);
  Temporary temporary(target);
  write_stream(path, temporary.path(), write);
  temporary.rename_to(target);
}

void write_path_atomically(const fs::path& path, const std::function<void(const fs::path&)>& write) {
  if (is_special(path)) return write(path);
  const fs::path target = resolved(path);
  Temporary temporary(target);
  write(temporary.path());
  temporary.rename_to(target);
}

}  // namespace brdf::io
