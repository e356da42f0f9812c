#ifdef BRDF_HAS_RENDER
#include "cli/steps/shown_shader.h"

#include <CLI/CLI.hpp>

#include "cli/options/options.h"
#include "io/files/error.h"
#include "render/gpu/held.h"

namespace brdf::cli {

void add_shown_shader(CLI::App& verb, ShownShader& shown) {
  add_shader_options(verb, shown.shader);
  add_repeated_option(verb, "--set", shown.set,
                      "Parameter of --shader: name=value, or one value per channel");
}

std::optional<Material> shown_material(const ShownShader& shown, const std::string& verb) {
  const auto shader = load(shown.shader, verb);
  if (!shader) {
    if (!shown.set.empty()) throw InputError("--set " + shown.set.front() + ": needs --shader FILE");
    return std::nullopt;
  }
  io::MaterialChoice choice;
  choice.made = shader->material;
  choice.set = shown.set;
  return render::with_room(io::choose_material(choice));
}

void show_shader(const ShownShader& shown, const std::string& verb, render::Job& job) {
  auto material = shown_material(shown, verb);
  if (!material) return;
  job.row_source = shown.shader.file;
  job.row.emplace_back(std::filesystem::path(shown.shader.file).filename().string(), std::move(*material));
}

}  // namespace brdf::cli
#endif
