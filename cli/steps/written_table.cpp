#include "cli/steps/written_table.h"

#include "io/files/error.h"
#include "io/files/provenance.h"
#ifdef BRDF_HAS_MAPS
#include "texel/planes.h"
#endif

namespace brdf::cli {

#ifdef BRDF_HAS_MAPS
void write_lookup_table(const std::string& path, const interop::LookupTable& table) {
  texel::Planes planes{table.width, table.height, {}, {}};
  for (std::size_t c = 0; c < table.channels.size(); ++c) {
    planes.names.emplace_back(c == 0 ? "R" : "G");
    planes.values.emplace_back(table.texels[c].begin(), table.texels[c].end());
  }
  planes.attributes = {{"brdf.command", io::provenance().command}};
  for (const std::string& sentence : interop::sentences(table))
    planes.attributes.emplace_back("brdf." + std::to_string(planes.attributes.size()), sentence);
  texel::write_planes(path, planes);
}
#else
void write_lookup_table(const std::string& path, const interop::LookupTable&) {
  throw InputError(path + ": this build has no OpenEXR, which tables need");
}
#endif

}  // namespace brdf::cli
