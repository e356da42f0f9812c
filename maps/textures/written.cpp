#include "maps/textures/written.h"

#include <algorithm>

#include "io/files/output.h"
#include "io/files/provenance.h"

namespace brdf::maps {
std::string_view suffix_of(const interop::Program& program) {
  return program.name == "materialx" ? ".mtlx" : program.name.starts_with("blender") ? ".py" : ".glb";
}

std::vector<std::filesystem::path> possible_files(const interop::Program&,
                                                  const std::filesystem::path& output) {
  return {output};
}

std::vector<std::filesystem::path> write_textures(const Carried& carried, const TexelMaterials& maps,
                                                  const std::filesystem::path& output,
                                                  const std::string& name) {
  const interop::Program& program = *carried.program;
  Description described{
      name,
      {"Written by brdf " BRDF_VERSION ": " + io::provenance().command, "for " + std::string(program.title)}};
  for (const auto* lines : {&program.conventions})
    described.header.insert(described.header.end(), lines->begin(), lines->end());
  for (const std::string& sentence : sentences(carried, maps)) described.header.push_back(sentence);
  io::write_file_atomically(output, glb_of(carried, maps, described));
  return {output};
}

}  // namespace brdf::maps
