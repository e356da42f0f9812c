// Files with textures for other programs.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <utility>
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

// The images of a program that reads images from files.
class ImageFiles {
 public:
  ImageFiles(const Carried& carried, const TexelMaterials& maps, std::filesystem::path output)
      : carried_(carried), maps_(maps), output_(std::move(output)) {}

  // Adds the image of an input, of the normals, or of the texels that are held (1, otherwise 0), and returns
  // its name without a folder. A number is stored three times, because not every reader accepts one channel.
  std::string add(const InputMap& map);
  std::string add_normals();
  std::string add_held();
  // Writes the images next to the output, and returns their paths.
  std::vector<std::filesystem::path> write() const;

 private:
  std::string add(std::string_view name, texel::Planes planes);

  const Carried& carried_;
  const TexelMaterials& maps_;
  std::filesystem::path output_;
  std::vector<std::pair<std::filesystem::path, texel::Planes>> files_{};
};

// Returns a nodegraph with its material, for materialx.
std::string mtlx_of(const Carried& carried, ImageFiles& images, const Description& described);
// Returns a script that makes the material and a plane, for blender and blender-3.4. `size`: width and height
// of the plane.
std::string script_of(const Carried& carried, ImageFiles& images, const Description& described,
                      const std::array<double, 2>& size);

}  // namespace brdf::maps
