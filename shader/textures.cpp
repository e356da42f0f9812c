#include "shader/textures.h"

#include <algorithm>
#include <set>

#include "io/files/error.h"
#include "io/files/numbers.h"
#include "io/files/text.h"

namespace brdf::shader {
namespace {

std::set<std::string> names_of_textures(const spirv::Module& module) {
  std::set<std::string> names;
  const auto look = [&](spirv::Id id, spirv::Id type) {
    const spirv::Type& t = module.type(type);
    const bool is = t.is_texture || (t.kind == spirv::Kind::pointer && module.type(t.element).is_texture);
    if (is && !module.name(id).empty()) names.insert(module.name(id));
  };
  for (const auto& [id, global] : module.globals)
    if (global.variable) look(id, global.instruction.type);
  for (const auto& [id, function] : module.functions)
    for (std::size_t k = 0; k < function.parameters.size(); ++k)
      look(function.parameters[k], function.parameter_types[k]);
  return names;
}

}  // namespace

std::map<std::string, Texture> textures_of(const spirv::Module& module, const Source& source) {
  std::map<std::string, Texture> out;
  if (source.textures.empty()) return out;
  const std::set<std::string> names = names_of_textures(module);
  for (const TextureChoice& choice : source.textures) {
    if (names.contains(choice.name)) {
      out[choice.name] = read_texture(choice);
    } else if (!source.shares_textures) {
      const std::string known = io::joined(std::vector<std::string>(names.begin(), names.end()));
      throw InputError(
          "--texture " + choice.name + ": " + source.name + " has no texture of this name " +
          (known.empty() ? "(it has no texture of two dimensions)" : "(its textures: " + known + ")"));
    }
  }
  return out;
}

std::string said_of_textures(const Function& function, const std::map<std::string, Texture>& textures) {
  std::vector<std::string> unread;
  for (const auto& [name, texture] : textures) {
    const auto read = [&](const std::shared_ptr<const TexelTable>& channel) {
      return channel != nullptr &&
             std::ranges::find(function.as_meant.tables, channel) != function.as_meant.tables.end();
    };
    if (std::ranges::none_of(texture.channels, read)) unread.push_back(name);
  }
  if (unread.empty()) return "";
  return "the value does not depend on the texels of " + io::joined(unread);
}

}  // namespace brdf::shader
