#include "cli/program/written_maps.h"

#include "io/files/error.h"
#ifdef BRDF_HAS_MAPS
#include "cli/options/progress.h"
#include "io/files/output.h"
#include "maps/textures/written.h"
#endif

namespace brdf::cli {

#ifdef BRDF_HAS_MAPS
namespace {

void check_files(const interop::Program& program, const MapFiles& files) {
  const std::filesystem::path suffix(maps::suffix_of(program));
  if (files.output.empty() || std::filesystem::path(files.output).extension() != suffix)
    throw InputError("--maps --to " + std::string(program.name) + ": needs -o NAME" + suffix.string());
  std::vector<io::Target> targets{{"--loss-map", files.loss_map}};
  for (const std::filesystem::path& path : maps::possible_files(program, files.output))
    targets.push_back({"-o", path});
  io::check_targets(targets);
}

}  // namespace

std::vector<std::string> textured_names() {
  const std::vector<std::string_view> names = maps::textured_programs();
  return {names.begin(), names.end()};
}

WrittenMaps write_maps(const interop::Program& program, const MapFiles& files) {
  check_files(program, files);
  const maps::TexelMaterials texels(files.maps);
  const maps::Carried carried = maps::carry(texels, program, progress_line("brdf export: rows of texels"));
  const std::string name =
      files.name.empty() ? std::filesystem::path(files.maps).stem().string() : files.name;
  io::Json written = io::Json::array();
  for (const std::filesystem::path& file : write_textures(carried, texels, files.output, name))
    written.push_back(file.string());
  if (!files.loss_map.empty()) texel::write_planes(files.loss_map, loss_planes(carried, texels));
  return {sentences(carried, texels),
          {{"kind", "maps"},
           {"target", info(carried.target).name},
           {"program", program.title},
           {"files", std::move(written)},
           {"maps", to_json(carried, texels)}},
          maps::summary_of(carried.losses.rms).largest};
}
#else
std::vector<std::string> textured_names() {
  return {};
}

WrittenMaps write_maps(const interop::Program&, const MapFiles& files) {
  throw InputError(files.maps + ": this build has no OpenEXR, which maps need");
}
#endif

}  // namespace brdf::cli
