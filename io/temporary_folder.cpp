#include "io/temporary_folder.h"

#include <stdlib.h>

#include <cerrno>
#include <string>
#include <system_error>

#include "io/output.h"

namespace brdf::io {

TemporaryFolder::TemporaryFolder(const std::filesystem::path& above) {
  make_folder(above);
  std::string name = (above / "brdf_XXXXXX").string();
  if (!mkdtemp(name.data())) cannot_write(above, errno);
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace brdf::io
