#include "io/any_table.h"

#include "io/error.h"
#include "io/exr_table.h"
#include "io/merl.h"

namespace brdf::io {

void check_table_format(const std::filesystem::path& path) {
  const std::string suffix = path.extension();
  if (suffix != ".csv" && suffix != ".binary" && suffix != ".exr")
    throw InputError(path.string() + ": unknown output format (known: .csv, .binary for MERL, .exr)");
}

std::vector<std::string> write_table(const std::filesystem::path& path, const SampleTable& table) {
  check_table_format(path);
  if (path.extension() == ".binary") return merl::write(path, table);
  if (path.extension() == ".exr") return write_exr_table(path, table);
  write_samples(path, table);
  return {};
}

}  // namespace brdf::io
