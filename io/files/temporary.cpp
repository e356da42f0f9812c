#include "io/files/temporary.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

#include "io/files/output.h"

namespace brdf::io {
namespace {

namespace fs = std::filesystem;

int make_file(const char* path) {
  return ::open(path, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
}

// Another process may remove the folder before this one opens it. The name is then reported as already
// taken (EEXIST), so that the caller tries another one.
int make_open_folder(const char* path) {
  if (::mkdir(path, 0700) != 0) return -1;
  const int folder = ::open(path, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (folder >= 0) return folder;
  const int error = errno == ENOENT ? EEXIST : errno;
  ::rmdir(path);
  errno = error;
  return -1;
}

// A process that may not change the owner of a file stays the owner. The permissions are set last because a
// change of owner clears some of them.
void take_over(int descriptor, const struct stat& replaced) {
  if (::fchown(descriptor, replaced.st_uid, replaced.st_gid) != 0) (void)0;
  ::fchmod(descriptor, replaced.st_mode & 0777);
}

fs::path made(const fs::path& above) {
  make_folder(above);
  return above / "brdf";
}

}  // namespace

Temporary::Temporary(const fs::path& target, const fs::path& shown, Make make) : shown_(shown) {
  sweep(target);
  while (descriptor_ < 0) {
    path_ = temporary_name(target);
    int error = 0;
    {
      const Undisturbed undisturbed;
      if (!listed_.set(path_.string())) cannot_write(shown_, ENAMETOOLONG);
      descriptor_ = make(path_.c_str());
      error = errno;
      if (descriptor_ < 0) listed_.clear();
    }
    // The entry belongs to another machine, or to an earlier process that had our number.
    if (descriptor_ < 0 && error == EEXIST) continue;
    if (descriptor_ < 0) cannot_write(shown_, error);
    if (is_held(descriptor_)) continue;
    ::close(descriptor_);
    descriptor_ = -1;
  }
}

// The descriptor is closed last: until then its lock keeps other processes from removing the entry.
Temporary::~Temporary() {
  listed_.remove();
  ::close(descriptor_);
}

TemporaryFile::TemporaryFile(const fs::path& target, const struct stat* replaced, const fs::path& shown)
    : Temporary(target, shown, make_file) {
  if (replaced) take_over(descriptor_, *replaced);
}

void TemporaryFile::rename_to(const fs::path& target) {
  // fsync() fails with EINVAL or ENOTSUP on a file system without a disk, for which there is nothing to
  // wait.
  if (::fsync(descriptor_) != 0 && errno != EINVAL && errno != ENOTSUP) broke_off(shown_, errno);
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

TemporaryFolder::TemporaryFolder(const fs::path& above) : Temporary(made(above), above, make_open_folder) {}

}  // namespace brdf::io
