// Forms of materials that are users' shaders. The room that reads shaders stands above this one, so it says
// here, once in a process, how a material names one.
#pragma once

#include <filesystem>

#include "brdf/material.h"
#include "io/files/json.h"

namespace brdf::io {

class ShaderForms {
 public:
  virtual ~ShaderForms() = default;
  // The shader that the object `shader` of a material names, files relative to this folder. Throws
  // InputError: it is not there, is not the one that the material is of, or is no reflectance.
  virtual Reflectance read(const JsonPlace& shader, const std::filesystem::path& folder) const = 0;
  // That object; null: the reflectance is no shader's. Files have absolute paths.
  virtual Json write(const Reflectance& form) const = 0;
  // The same as a file in this folder names it: relative to the folder, where the user named it by a relative
  // path.
  virtual Json write(const Reflectance& form, const std::filesystem::path& folder) const = 0;
};

// From now on materials with shaders are read and written by `forms`, which lives as long as the process.
void use_shader_forms(const ShaderForms& forms);
// Null: this program reads no shaders.
const ShaderForms* shader_forms();

// A reflectance that stands for another one, some of whose parameters it holds: files have that one.
class StandsFor {
 public:
  virtual ~StandsFor() = default;
  virtual Term whole(const Term& term) const = 0;
};

// The term itself, or the one that its form stands for.
Term whole_term(const Term& term);

inline constexpr const char* kShader = "shader";  // the key of a term

// The form of a term that has that key. Throws InputError.
Reflectance read_shader(const JsonPlace& term);
// What that key holds, as a file in this folder names it (null: by absolute paths); null where the form is no
// shader's.
Json shader_json(const Reflectance& form, const std::filesystem::path* folder);

// A document that was made beside the material, as the `fit` block is, names its shaders by absolute paths
// and has their texts. In the material's file it names them as the material does, without the texts; once
// that is read, as before.
void name_shaders_from(const std::filesystem::path& file, Json& document, const Material& material);
void name_shaders_from_here(Json& document, const Material& material, const std::filesystem::path& file);

}  // namespace brdf::io
