// The choices that a command line makes for a shader.
#pragma once

#include <string>
#include <vector>

#include "shader/front/source.h"

namespace brdf::shader {

// `parameters` are the texts of --param. `entry` and `returns` take precedence over the file unless they
// are empty. `defines` are NAME=VALUE, NAME (equal to NAME=1) or NAME= (an empty value); they take effect
// before the first line, and also in included files. `include_folders` are searched in their order, after
// the file's own folder.
struct ShaderChoice {
  std::string file;
  std::vector<std::string> parameters = {};
  std::string entry = {}, returns = {};
  std::vector<std::string> defines = {}, include_folders = {};
  std::string sample = {}, pdf = {};  // the sampler and the density of the file; empty: found by their names
  std::vector<TextureChoice> textures = {};
  bool shares_textures = false;  // some of the textures may belong to other shaders
};

// Adds the choice to the source. Throws InputError if a text cannot be parsed, a macro is defined twice
// with different values, an include folder is not a folder, or a texture is given twice.
void choose(Source& source, const ShaderChoice& choice);

// Returns the command line options that make the same choice.
std::string command_words(const ShaderChoice& choice);

}  // namespace brdf::shader
