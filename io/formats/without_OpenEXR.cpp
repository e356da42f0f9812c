// OpenEXR tables in a build without the package: recognised and refused by name.
#include "io/files/error.h"
#include "io/formats/exr_table.h"

namespace brdf::io {

std::vector<std::string> write_exr_table(const std::filesystem::path& path, const SampleTable&) {
  throw InputError(path.string() + ": this build has no OpenEXR: write .csv");
}

namespace exr {

bool recognises(const Content& content) {
  return content.bytes.starts_with("\x76\x2f\x31\x01");
}

SampleTable read(const Content& content, const Supplied&) {
  throw InputError(content.name +
                   ": is an OpenEXR file, which this build cannot read: convert it with the program, `brdf "
                   "convert FILE.exr --output FILE.csv`");
}

}  // namespace exr
}  // namespace brdf::io
