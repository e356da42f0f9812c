#include "shader/material_form.h"

#include <filesystem>
#include <map>
#include <mutex>

#include "io/files/content.h"
#include "io/files/digest.h"
#include "io/material/shader_forms.h"
#include "shader/shader.h"

namespace brdf::shader {
namespace {

namespace fs = std::filesystem;
using io::Json;
using io::JsonPlace;

std::string absolute_path(const std::string& file) {
  return fs::weakly_canonical(fs::absolute(file)).string();
}
std::string relative_path(const std::string& file, const fs::path& folder) {
  const fs::path from = fs::weakly_canonical(fs::absolute(folder.empty() ? "." : folder));
  return fs::path(absolute_path(file)).lexically_relative(from).string();
}

// All members of a choice are unpacked here, so that a new member does not compile until materials store
// it.
template <class Path>
Json choice_json(const ShaderOrigin& origin, const Path& path) {
  const auto& [file, parameters, entry, returns, defines, include_folders, sample, pdf, textures, shares] =
      origin.choice;
  Json json;
  json["file"] = origin.text.empty() ? path(file) : fs::path(file).filename().string();
  json["sha256"] = origin.sha256;
  if (!parameters.empty()) json["parameters"] = parameters;
  if (!entry.empty()) json["entry"] = entry;
  if (!returns.empty()) json["returns"] = returns;
  if (!defines.empty()) json["defines"] = defines;
  if (!sample.empty()) json["sample"] = sample;
  if (!pdf.empty()) json["pdf"] = pdf;
  for (const std::string& folder : include_folders) json["include_folders"].push_back(path(folder));
  for (std::size_t k = 0; k < textures.size() && !shares; ++k)
    json["textures"].push_back({{"name", textures[k].name},
                                {"file", path(textures[k].file)},
                                {"sha256", origin.texture_sha256[k]},
                                {"filter", name_of(textures[k].filter)},
                                {"wrap", name_of(textures[k].wrap)}});
  if (!origin.text.empty()) json["text"] = origin.text;
  return json;
}

std::vector<std::string> texts_of(const JsonPlace& place, const char* key) {
  std::vector<std::string> texts;
  if (!place.has(key)) return texts;
  const JsonPlace list = place.at(key);
  for (std::size_t k = 0; k < list.size(); ++k) texts.push_back(list.at(k).text());
  return texts;
}

template <class Rule>
Rule rule_of(const JsonPlace& place) {
  const auto rule = find_named<Rule>(place.text());
  if (!rule) place.fail("must be one of " + known_names<Rule>());
  return *rule;
}

void read_textures(const JsonPlace& list, const fs::path& folder, ShaderOrigin& origin) {
  for (std::size_t k = 0; k < list.size(); ++k) {
    const JsonPlace place = list.at(k);
    place.allow_keys({"name", "file", "sha256", "filter", "wrap"});
    origin.choice.textures.push_back({place.at("name").text(), (folder / place.at("file").text()).string(),
                                      rule_of<TextureFilter>(place.at("filter")),
                                      rule_of<TextureWrap>(place.at("wrap"))});
    origin.texture_sha256.push_back(place.at("sha256").text());
  }
}

ShaderOrigin read_origin(const JsonPlace& place, const fs::path& folder) {
  place.allow_keys({"file", "sha256", "parameters", "entry", "returns", "defines", "include_folders",
                    "sample", "pdf", "textures", "text"});
  ShaderOrigin origin;
  const fs::path file = place.at("file").text();
  origin.relative = file.is_relative();
  origin.sha256 = place.at("sha256").text();
  if (place.has("text")) origin.text = place.at("text").text();
  origin.choice = {origin.text.empty() ? (folder / file).string() : file.string(),
                   texts_of(place, "parameters"),
                   place.has("entry") ? place.at("entry").text() : "",
                   place.has("returns") ? place.at("returns").text() : "",
                   texts_of(place, "defines"),
                   texts_of(place, "include_folders"),
                   place.has("sample") ? place.at("sample").text() : "",
                   place.has("pdf") ? place.at("pdf").text() : ""};
  for (std::string& include : origin.choice.include_folders) include = (folder / include).string();
  if (place.has("textures")) read_textures(place.at("textures"), folder, origin);
  return origin;
}

void check_textures(const JsonPlace& place, const ShaderOrigin& origin) {
  for (std::size_t k = 0; k < origin.choice.textures.size(); ++k) {
    const std::string& file = origin.choice.textures[k].file;
    const JsonPlace texture = place.at("textures").at(k);
    std::error_code error;
    if (!fs::exists(file, error))
      texture.at("file").fail("does not exist (" + absolute_path(file) + "): move the texture to this place");
    if (io::sha256(io::read_content(file).bytes) != origin.texture_sha256[k])
      texture.at("sha256").fail(
          "does not match " + file +
          ", which has changed since this material was made: restore the old file, or fit "
          "the samples again with --shader and --texture");
  }
}

// Checks that the text is the text that the material was made with. Reports the reason as an error if it is
// not.
void check_text(const JsonPlace& place, const ShaderOrigin& origin) {
  check_textures(place, origin);
  if (!origin.text.empty()) {
    if (io::sha256(origin.text) != origin.sha256)
      place.at("sha256").fail("does not match the text: one of the two was changed");
    return;
  }
  const std::string& file = origin.choice.file;
  std::error_code error;
  if (!fs::exists(file, error))
    place.at("file").fail(
        "does not exist (" + absolute_path(file) +
        "): move the shader to this place, or store its text in the material with brdf fit --embed");
  for (std::size_t k = 0; k < origin.choice.include_folders.size(); ++k)
    if (!fs::is_directory(origin.choice.include_folders[k], error))
      place.at("include_folders")
          .at(k)
          .fail("is not a folder (" + absolute_path(origin.choice.include_folders[k]) + ")");
  if (io::sha256(whole_text(origin.choice)) != origin.sha256)
    place.at("sha256").fail("does not match " + file +
                            ", which (or a file that it includes) has changed since this material was made: "
                            "restore the old text, or fit the samples again with --shader " +
                            file + "; use --shader and --set to evaluate the new text");
}

class Forms final : public io::ShaderForms {
 public:
  Reflectance read(const JsonPlace& place, const fs::path& folder) const override {
    const ShaderOrigin origin = read_origin(place, folder);
    check_text(place, origin);
    // The same shader gives the same form: a file names the shader in its terms and again in the record of
    // its fit.
    Json choice = choice_json(origin, absolute_path);
    const std::string key = io::to_line(choice) + (origin.relative ? "r" : "a");
    const std::lock_guard lock(mutex_);
    const auto found = known_.find(key);
    if (found != known_.end()) return found->second;
    const Reflectance form(shader_from(origin));
    known_.emplace(key, form);
    return form;
  }

  Json write(const Reflectance& form) const override {
    const ShaderReflectance* shader = shader_of(form);
    return shader == nullptr || !shader->origin() ? Json(nullptr)
                                                  : choice_json(*shader->origin(), absolute_path);
  }

  Json write(const Reflectance& form, const fs::path& folder) const override {
    const ShaderReflectance* shader = shader_of(form);
    if (shader == nullptr || !shader->origin()) return nullptr;
    const ShaderOrigin& origin = *shader->origin();
    return choice_json(origin, [&](const std::string& file) {
      return origin.relative ? relative_path(file, folder) : absolute_path(file);
    });
  }

 private:
  mutable std::mutex mutex_;
  mutable std::map<std::string, Reflectance> known_;
};

}  // namespace

void use_in_materials() {
  static const Forms forms;
  io::use_shader_forms(forms);
}

const ShaderReflectance* shader_of(const Reflectance& reflectance) {
  return dynamic_cast<const ShaderReflectance*>(&*reflectance);
}

}  // namespace brdf::shader
