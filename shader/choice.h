// What a command line says of a shader.
#pragma once

#include <string>
#include <vector>

#include "shader/front/source.h"

namespace brdf::shader {

// `parameters` are --param's texts; `entry` and `returns` win over the file's where they are not empty;
// `defines` are NAME=VALUE, NAME (then 1) or NAME= (then nothing), before the first line and in included
// files; `include_folders` are searched after the file's own, in their order.
struct ShaderChoice {
  std::string file;
  std::vector<std::string> parameters = {};
  std::string entry = {}, returns = {};
  std::vector<std::string> defines = {}, include_folders = {};
};

// Makes it part of the source. Throws InputError where a text is not understood, a macro is defined twice, or
// a folder is none.
void choose(Source& source, const ShaderChoice& choice);

// The words of a command line that say the same.
std::string command_words(const ShaderChoice& choice);

}  // namespace brdf::shader
