// Option --shader and the options that control the reading of shaders, identical in every verb.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "brdf/direction_sampler.h"
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
  std::vector<std::string> defines, include_folders, textures;
  bool shares_textures = false;  // the textures of many shaders
  std::string sample, pdf;       // of validate alone
  bool embed = false;            // materials of the shader hold its text
};

// Adds --shader, --param, --entry, --returns, --define, -I and --texture.
void add_shader_options(CLI::App& verb, ShaderOptions& options);
// Adds --sample and --pdf.
void add_sampler_options(CLI::App& verb, ShaderOptions& options);

#ifdef BRDF_HAS_SHADER
// Converts the options for the library that reads shaders.
shader::ShaderChoice choice_of(const ShaderOptions& options);
#endif

// Returns the suffixes of the files that a folder of shaders is searched for, in lower case. Throws
// EnvironmentError if this build has no shader compiler.
std::vector<std::string> shader_suffixes();

// A shader's file as verbs need it.
struct LoadedShader {
  Reflectance reflectance;
  Material material;               // at the shader's own defaults
  std::string words;               // equivalent words of a command line
  std::vector<std::string> notes;  // sentences on the interpretation of the file
  bool oriented = false;           // the shader reads the tangent
  // True unless the values are known to be unchanged if both directions turn together about the normal.
  bool may_turn = true;
  // True unless half of the azimuths is known to represent all of them.
  bool all_round = true;
  std::size_t operations = 0;  // operations of an evaluation, with all calls inlined
  // Returns the source line that causes the result of a check (validate/search/subject.h).
  std::function<std::string(std::string_view check, const Material& at, const Vec3<double>& wi,
                            const Vec3<double>& wo)>
      explain;
  // Does the same for a jump between two pairs of directions.
  std::function<std::string(const Material& at, const Vec3<double>& wi, const Vec3<double>& wo,
                            const Vec3<double>& other_wi, const Vec3<double>& other_wo)>
      explain_jump;
  std::function<std::string(const Material& at, const Vec3<double>& wi, const Vec3<double>& wo)> undefined;
  std::function<std::vector<double>(const Material& at, const Vec3<double>& wi, const Vec3<double>& wo)>
      in_more_digits;
  // In half precision (validate/search/subject.h).
  std::function<std::vector<double>(const Material& at, const Vec3<double>& wi, const Vec3<double>& wo)>
      in_half;
  std::string half_unknown;
  bool has_half_types = false;
  std::shared_ptr<const DirectionSampler> sampler;  // of the same file; null if it has none
  // The comparisons of an evaluation, and the text of a line (validate/search/subject.h).
  std::function<void(
      const Material& at, const Vec3<double>& wi, const Vec3<double>& wo,
      const std::function<void(std::uint32_t number, std::uint32_t line, bool holds, double surplus)>& look)>
      for_each_comparison;
  std::function<std::string(std::uint32_t line)> text_of_line;
};

// Returns true if --shader is given. Checks the options and throws as load() does.
bool is_given(const ShaderOptions& options);

// Loads the shader, or returns std::nullopt if --shader is not given. Notes are printed on stderr unless
// `quiet` is true. Throws InputError if the file is not a reflectance, or if the other options are given
// without --shader; EnvironmentError if this build has no shader compiler.
std::optional<LoadedShader> load(const ShaderOptions& options, const std::string& verb, bool quiet = false);

// Returns the shader of a material whose only term is a shader, and std::nullopt for other materials.
// `words` are empty.
std::optional<LoadedShader> shader_in(const Material& material);
// Enables materials that name shaders, for reading and writing. If this build has no shader compiler, such
// materials are refused.
void use_shaders_in_materials();

// A material from --form, --material and --set, or from a shader and --set.
struct MaterialOptions : io::MaterialChoice {
  ShaderOptions shader;
};
// Adds --form, --material, --set and the options of a shader.
void add_material_options(CLI::App& verb, MaterialOptions& options);
// Adds the positional argument MATERIAL, with the meaning of --material. Call this function after
// add_material_options().
void add_material_argument(CLI::App& verb, MaterialOptions& options);
// Returns the chosen material, and choose_material_file() the whole file. Notes on stderr begin with `verb`.
Material choose_material(const MaterialOptions& options, const std::string& verb);
io::MaterialFile choose_material_file(const MaterialOptions& options, const std::string& verb);

}  // namespace brdf::cli
