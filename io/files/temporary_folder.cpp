#include "io/files/temporary_folder.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

#include "io/files/output.h"

namespace brdf::io {

TemporaryFolder::TemporaryFolder(const std::filesystem::path& above) {
  make_folder(above);
  const std::filesystem::path target = above / "brdf";
  sweep(target);
  create(target);
}

void TemporaryFolder::create(const std::filesystem::path& target) {
  while (descriptor_ < 0) {
    path_ = temporary_name(target);
    int error = 0;
    {
      const Undisturbed undisturbed;
      if (!listed_.set(path_.string())) cannot_write(target.parent_path(), ENAMETOOLONG);
      error = ::mkdir(path_.c_str(), 0700) == 0 ? 0 : errno;
      if (error != 0) listed_.clear();
    }
    if (error == EEXIST) continue;  // another machine's, or another's that had our number
    if (error != 0) cannot_write(target.parent_path(), error);
    descriptor_ = ::open(path_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor_ < 0) {
      error = errno;
      if (error == ENOENT) continue;  // swept
      listed_.remove();
      cannot_write(path_, error);
    }
    if (is_held(descriptor_)) continue;
    ::close(descriptor_);
    descriptor_ = -1;
  }
}

TemporaryFolder::~TemporaryFolder() {
  listed_.remove();
  ::close(descriptor_);
}

}  // namespace brdf::io
