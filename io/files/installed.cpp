#include "io/files/installed.h"

#include <dlfcn.h>

#include <system_error>

namespace brdf::io {
namespace {

namespace fs = std::filesystem;

// The path of the object that contains this code: a shared library, the Python module or the program. For a
// program the loader gives only the name by which it was called.
fs::path own_object() {
  static const char here = 0;
  Dl_info found;
  return dladdr(&here, &found) != 0 && found.dli_fname ? fs::path(found.dli_fname) : fs::path();
}

}  // namespace

fs::path installed_file(std::string_view name) {
  std::error_code error;  // a path that is not accessible counts as missing
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  const fs::path object = fs::canonical(own_object(), error);
  for (const fs::path& folder :
       {program.parent_path() / BRDF_SHARE_FROM_BIN, object.parent_path() / BRDF_SHARE_FROM_LIB,
        object.parent_path() / BRDF_SHARE_FROM_MODULE}) {
    const fs::path file = (folder / name).lexically_normal();
    if (file.is_absolute() && fs::is_regular_file(file, error)) return file;
  }
  return {};
}

fs::path here_or_installed(const fs::path& file) {
  std::error_code error;
  if (file.empty() || file.is_absolute() || fs::exists(file, error)) return file;
  const fs::path installed = installed_file((fs::path("brdf") / file).generic_string());
  return installed.empty() ? file : installed;
}

}  // namespace brdf::io
