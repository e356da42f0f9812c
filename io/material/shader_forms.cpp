#include "io/material/shader_forms.h"

namespace brdf::io {
namespace {

const ShaderForms* used_forms = nullptr;

// Returns pairs for the shaders of a material: first with absolute paths and texts, second as the
// material's file names them, without texts.
std::vector<std::pair<Json, Json>> named_shaders(const Material& material,
                                                 const std::filesystem::path& file) {
  std::vector<std::pair<Json, Json>> names;
  const std::filesystem::path folder = file.parent_path();
  for (const Term& term : material.terms) {
    Json whole = shader_json(term.form, nullptr);
    if (whole.is_null()) continue;
    Json brief = shader_json(term.form, &folder);
    brief.erase("text");
    names.emplace_back(std::move(whole), std::move(brief));
  }
  return names;
}

void exchange(Json& json, const Json& from, const Json& to) {
  if (!json.is_structured()) return;
  for (auto& [key, value] : json.items()) {
    if (key == kShader && value == from)
      value = to;
    else
      exchange(value, from, to);
  }
}

}  // namespace

void use_shader_forms(const ShaderForms& forms) {
  used_forms = &forms;
}

const ShaderForms* shader_forms() {
  return used_forms;
}

Term whole_term(const Term& term) {
  const auto* part = dynamic_cast<const StandsFor*>(&*term.form);
  return part == nullptr ? term : part->whole(term);
}

Reflectance read_shader(const JsonPlace& term) {
  if (used_forms == nullptr) term.at(kShader).fail("names a shader, but this program does not read shaders");
  const std::filesystem::path file = term.file();
  const Reflectance form = used_forms->read(term.at(kShader), file.parent_path());
  if (term.at("form").text() != form.info().name)
    term.at("form").fail("must be " + std::string(form.info().name) + ", the name of its shader");
  return form;
}

Json shader_json(const Reflectance& form, const std::filesystem::path* folder) {
  if (used_forms == nullptr) return nullptr;
  return folder == nullptr ? used_forms->write(form) : used_forms->write(form, *folder);
}

void name_shaders_from(const std::filesystem::path& file, Json& document, const Material& material) {
  for (const auto& [whole, brief] : named_shaders(material, file)) exchange(document, whole, brief);
}

void name_shaders_from_here(Json& document, const Material& material, const std::filesystem::path& file) {
  for (const auto& [whole, brief] : named_shaders(material, file)) exchange(document, brief, whole);
}

}  // namespace brdf::io
