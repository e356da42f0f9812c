// The textures that a command line gives to a shader.
#pragma once

#include <map>
#include <string>

#include "shader/function.h"
#include "shader/spirv/module.h"

namespace brdf::shader {

// Reads the files of the source's textures, by the names of the module's variables and arguments. Throws
// InputError if a file cannot be used, or if the module has no texture of a name, unless the source shares
// its textures with other shaders.
std::map<std::string, Texture> textures_of(const spirv::Module& module, const Source& source);

// Returns a note on the textures from which the function reads no texel; empty if it reads all of them.
std::string said_of_textures(const Function& function, const std::map<std::string, Texture>& textures);

}  // namespace brdf::shader
