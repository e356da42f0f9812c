// Files with textures for other programs.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "maps/textures/carried.h"

namespace brdf::maps {

// Returns the suffix of the file that a program reads: .glb, .mtlx or .py.
std::string_view suffix_of(const interop::Program& program);

// Returns the paths of all files that write_textures() may write for `output`, the file itself first. The
// images of programs that read images from files are STEM_INPUT.exr in the same folder.
std::vector<std::filesystem::path> possible_files(const interop::Program& program,
                                                  const std::filesystem::path& output);

// Writes the material with its textures, and returns the written paths. Every file is written completely or
// not at all, the images first.
std::vector<std::filesystem::path> write_textures(const Carried& carried, const TexelMaterials& maps,
                                                  const std::filesystem::path& output,
                                                  const std::string& name);

// The description of a written file: name of the material, and the lines of its header.
struct Description {
  std::string name;
  std::vector<std::string> header;
};
// Returns a .glb: a plane with the material, as large as 2 along its longer side.
std::string glb_of(const Carried& carried, const TexelMaterials& maps, const Description& described);

}  // namespace brdf::maps
