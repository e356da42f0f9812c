#include "cli/steps/written_table.h"

#include <algorithm>

#include "interop/cosine_transform.h"
#include "interop/lookup_table.h"
#include "io/files/error.h"
#include "io/files/provenance.h"
#ifdef BRDF_HAS_MAPS
#include "texel/planes.h"
#endif

namespace brdf::cli {
namespace {

using Planes = std::vector<std::pair<std::string, std::vector<double>>>;

#ifdef BRDF_HAS_MAPS
void write_image(const std::string& path, std::size_t width, std::size_t height, const Planes& named,
                 const std::vector<std::string>& sentences) {
  texel::Planes planes{width, height, {}, {}};
  for (const auto& [name, values] : named) {
    planes.names.push_back(name);
    planes.values.emplace_back(values.begin(), values.end());
  }
  planes.attributes = {{"brdf.command", io::provenance().command}};
  for (const std::string& sentence : sentences)
    planes.attributes.emplace_back("brdf." + std::to_string(planes.attributes.size()), sentence);
  texel::write_planes(path, planes);
}
#else
void write_image(const std::string& path, std::size_t, std::size_t, const Planes&,
                 const std::vector<std::string>&) {
  throw InputError(path + ": this build has no OpenEXR, which tables need");
}
#endif

WrittenTable write_transforms(const Material& material, const std::string& path) {
  const interop::CosineTable table = interop::cosine_table(material);
  Planes planes;
  for (const auto& [name, member] : {std::pair{"R", &interop::CosineTransform::x},
                                     {"G", &interop::CosineTransform::y},
                                     {"B", &interop::CosineTransform::z},
                                     {"A", &interop::CosineTransform::w}}) {
    std::vector<double> values;
    for (const interop::CosineTransform& transform : table.transforms) values.push_back(transform.*member);
    planes.emplace_back(name, std::move(values));
  }
  planes.emplace_back("albedo.white", table.white);
  planes.emplace_back("albedo.bias", table.bias);
  WrittenTable out{interop::sentences(table), interop::to_json(table), table.not_converged};
  write_image(path, table.side, table.side, planes, out.sentences);
  return out;
}

}  // namespace

bool is_lookup_table(std::string_view to) {
  return std::ranges::find(kTables, to) != std::end(kTables);
}

WrittenTable write_lookup_table(std::string_view to, const Material& material, std::string_view layout,
                                const std::string& path) {
  if (to == "ltc") return write_transforms(material, path);
  const interop::LookupTable table =
      interop::lookup_table(material, to == "dfg" ? interop::TableKind::dfg : interop::TableKind::albedo,
                            *interop::find_table_layout(layout));
  Planes planes;
  for (std::size_t c = 0; c < table.channels.size(); ++c)
    planes.emplace_back(c == 0 ? "R" : "G", table.texels[c]);
  WrittenTable out{interop::sentences(table), interop::to_json(table), table.not_converged};
  write_image(path, table.width, table.height, planes, out.sentences);
  return out;
}

}  // namespace brdf::cli
