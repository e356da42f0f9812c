#include "io/files/temporary.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

#include "io/files/output.h"

namespace brdf::io {

namespace fs = std::filesystem;

Temporary::Temporary(const fs::path& target, const struct stat* replaced, const fs::path& shown)
    : shown_(shown) {
  sweep(target);
  create(target);
  if (replaced) take_over(*replaced);
}

void Temporary::create(const fs::path& target) {
  while (descriptor_ < 0) {
    path_ = temporary_name(target).string();
    int error = 0;
    {
      const Undisturbed undisturbed;
      if (!listed_.set(path_)) cannot_write(shown_, ENAMETOOLONG);
      descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
      error = errno;
      if (descriptor_ < 0) listed_.clear();
    }
    if (descriptor_ < 0 && error == EEXIST) continue;  // another machine's, or another's that had our number
    if (descriptor_ < 0) cannot_write(shown_, error);
    if (is_held(descriptor_)) continue;
    ::close(descriptor_);
    descriptor_ = -1;
  }
}

// Who may not give a file away keeps it; permissions come last, because a change of owner takes some of them.
void Temporary::take_over(const struct stat& replaced) {
  if (::fchown(descriptor_, replaced.st_uid, replaced.st_gid) != 0) (void)0;
  ::fchmod(descriptor_, replaced.st_mode & 0777);
}

Temporary::~Temporary() {
  if (descriptor_ >= 0) ::close(descriptor_);
  listed_.remove();
}

void Temporary::rename_to(const fs::path& target) {
  // A file system without a disk has nothing to wait for.
  if (::fsync(descriptor_) != 0 && errno != EINVAL && errno != ENOTSUP) broke_off(shown_, errno);
  // Not closed before: the lock tells others that the file is not to be swept.
  int error = 0;
  {
    const Undisturbed undisturbed;
    if (::rename(path_.c_str(), target.c_str()) == 0)
      listed_.clear();
    else
      error = errno;
  }
  if (error != 0) cannot_write(shown_, error);
}

}  // namespace brdf::io
