#include "maps/textures/written.h"

#include <algorithm>

#include "io/files/output.h"
#include "io/files/provenance.h"

namespace brdf::maps {

std::string_view suffix_of(const interop::Program& program) {
  return program.name == "materialx" ? ".mtlx" : program.name.starts_with("blender") ? ".py" : ".glb";
}

std::vector<std::filesystem::path> write_textures(const Carried& carried, const TexelMaterials& maps,
                                                  const std::filesystem::path& output,
                                                  const std::string& name) {
  const interop::Program& program = *carried.program;
  Description described{
      name,
      {"Written by brdf " BRDF_VERSION ": " + io::provenance().command, "for " + std::string(program.title)}};
  described.header.insert(described.header.end(), program.conventions.begin(), program.conventions.end());
  for (const std::string& sentence : sentences(carried, maps)) described.header.push_back(sentence);
  ImageFiles images(carried, maps, output);
  const double larger = double(std::max(maps.width(), maps.height()));
  const std::string_view suffix = suffix_of(program);
  const std::string text =
      suffix == ".mtlx" ? mtlx_of(carried, images, described)
      : suffix == ".py" ? script_of(carried, images, described,
                                    {2 * double(maps.width()) / larger, 2 * double(maps.height()) / larger})
                        : glb_of(carried, maps, described);
  std::vector<std::filesystem::path> paths = images.write();
  io::write_file_atomically(output, text);
  paths.push_back(output);
  return paths;
}

}  // namespace brdf::maps
