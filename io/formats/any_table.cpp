#include "io/formats/any_table.h"

#include "io/csv/csv.h"
#include "io/files/error.h"
#include "io/formats/astm.h"
#include "io/formats/bird.h"
#include "io/formats/exr_table.h"
#include "io/formats/klems_write.h"
#include "io/formats/merl.h"
#include "io/formats/openmaterial.h"
#include "io/formats/zemax.h"

namespace brdf::io {

void check_table_format(const std::filesystem::path& path) {
  const std::string suffix = path.extension();
  if (suffix != ".csv" && suffix != ".binary" && suffix != ".exr" && suffix != ".astm" &&
      suffix != ".zemax" && suffix != ".xompt" && suffix != ".brdf" && suffix != ".xml")
    throw InputError(
        path.string() +
        ": unknown output format (known: .csv, .binary for MERL, .exr, .astm for ASTM E1392, .zemax for "
        "lens-design text, .xompt for OpenMATERIAL, .brdf for BiRD, .xml for Klems matrices)");
}

std::vector<std::string> write_table(const std::filesystem::path& path, const SampleTable& table) {
  check_table_format(path);
  if (path.extension() == ".binary") return merl::write(path, table);
  if (path.extension() == ".exr") return write_exr_table(path, table);
  if (path.extension() == ".astm") return astm::write(path, table);
  if (path.extension() == ".zemax") return zemax::write(path, table);
  if (path.extension() == ".xompt") return openmaterial::write(path, table);
  if (path.extension() == ".brdf") return bird::write(path, table);
  if (path.extension() == ".xml") return klems::write(path, table);
  write_samples(path, table);
  return {};
}

}  // namespace brdf::io
