// Forms of materials that are users' shaders. The library that reads shaders depends on this one, so a
// process registers here once how a material names a shader.
#pragma once

#include <filesystem>

#include "brdf/material.h"
#include "io/files/json.h"

namespace brdf::io {

class ShaderForms {
 public:
  virtual ~ShaderForms() = default;
  // Returns the shader that the object `shader` of a material names. Files are relative to `folder`. Throws
  // InputError if the shader does not exist, differs from the shader of the material, or is not a
  // reflectance.
  virtual Reflectance read(const JsonPlace& shader, const std::filesystem::path& folder) const = 0;
  // Returns the object `shader`, with absolute paths, or null if the reflectance is not a shader.
  virtual Json write(const Reflectance& form) const = 0;
  // Returns the object `shader` as a file in `folder` names it: paths are relative to the folder if the
  // user gave a relative path.
  virtual Json write(const Reflectance& form, const std::filesystem::path& folder) const = 0;
};

// Makes `forms` read and write materials with shaders from now on. `forms` must live as long as the
// process.
void use_shader_forms(const ShaderForms& forms);
// Returns the registered object, or null if this program reads no shaders.
const ShaderForms* shader_forms();

// A reflectance that represents another one with some parameters fixed. Files contain the original
// reflectance.
class StandsFor {
 public:
  virtual ~StandsFor() = default;
  // Returns the term of the reflectance that the form of `term` represents.
  virtual Term whole(const Term& term) const = 0;
};

// Returns the term itself, or the term of the reflectance that its form represents.
Term whole_term(const Term& term);

inline constexpr const char* kShader = "shader";  // the key of a term

// Returns the form of a term that has the key `shader`. Throws InputError.
Reflectance read_shader(const JsonPlace& term);
// Returns the value of this key as a file in `folder` names it; with absolute paths if `folder` is null.
// Returns null if the form is not a shader.
Json shader_json(const Reflectance& form, const std::filesystem::path* folder);

// A document that was made together with the material, such as the `fit` block, contains shaders by
// absolute paths and with their texts. The first function replaces them by the names that the material's
// file uses, without the texts; the second restores them after such a file is read.
void name_shaders_from(const std::filesystem::path& file, Json& document, const Material& material);
void name_shaders_from_here(Json& document, const Material& material, const std::filesystem::path& file);

}  // namespace brdf::io
