// --shader and what says how to read it, the same in every verb.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "brdf/material.h"
#include "io/material/settings.h"
#ifdef BRDF_HAS_SHADER
#include "shader/choice.h"
#endif

namespace CLI {
class App;
}

namespace brdf::cli {

struct ShaderOptions {
  std::string file = {};
  std::vector<std::string> parameters;
  std::string entry, returns;
  std::vector<std::string> defines, include_folders;
  bool embed = false;  // materials of it hold its text
};

// --shader, --param, --entry, --returns, --define, -I.
void add_shader_options(CLI::App& verb, ShaderOptions& options);

#ifdef BRDF_HAS_SHADER
// The same for the room that reads shaders.
shader::ShaderChoice choice_of(const ShaderOptions& options);
#endif

// What a verb needs of a shader's file.
struct LoadedShader {
  Reflectance reflectance;
  Material material;               // at the shader's own defaults
  std::string words;               // of a command line that says the same
  std::vector<std::string> notes;  // sentences on how it was read
  bool oriented = false;           // reads the tangent
  bool may_turn = true;            // light and viewer are not known to be free to turn together
  bool all_round = true;           // half of the azimuths is not known to stand for all
  std::size_t operations = 0;      // of an evaluation, with all calls inlined
  // The source line that what a check found comes from (validate/search/subject.h).
  std::function<std::string(std::string_view check, const Material& at, const Vec3<double>& wi,
                            const Vec3<double>& wo)>
      explain;
  std::function<std::string(const Material& at, const Vec3<double>& wi, const Vec3<double>& wo,
                            const Vec3<double>& other_wi, const Vec3<double>& other_wo)>
      explain_jump;
  std::function<std::string(const Material& at, const Vec3<double>& wi, const Vec3<double>& wo)> undefined;
  std::function<std::vector<double>(const Material& at, const Vec3<double>& wi, const Vec3<double>& wo)>
      in_more_digits;
};

// The choice that the options make, checked: none where --shader is not given. Throws as load does.
bool is_given(const ShaderOptions& options);

// Nothing where --shader is not given. Notes are printed on stderr unless `quiet`. Throws InputError where
// the file is no reflectance, or the other options are given without it; EnvironmentError where this build
// has no shader compiler.
std::optional<LoadedShader> load(const ShaderOptions& options, const std::string& verb, bool quiet = false);

// The same of a material of one term whose form is a shader; nothing of others. `words` are empty.
std::optional<LoadedShader> shader_in(const Material& material);
// From now on materials name shaders, and those that do are read; where this build has no shader compiler
// they are refused.
void use_shaders_in_materials();

// --form, --material and --set, or a shader and --set.
struct MaterialOptions : io::MaterialChoice {
  ShaderOptions shader;
};
void add_material_options(CLI::App& verb, MaterialOptions& options);
Material choose_material(const MaterialOptions& options, const std::string& verb);
io::MaterialFile choose_material_file(const MaterialOptions& options, const std::string& verb);

}  // namespace brdf::cli
