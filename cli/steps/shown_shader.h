// Option --shader in the verbs that show pictures: render and view.
#pragma once

#include "cli/options/shader_options.h"
#include "render/job.h"

namespace brdf::cli {

struct ShownShader {
  ShaderOptions shader;
  std::vector<std::string> set;
};

// Adds --shader, the options that control its reading, and --set.
void add_shown_shader(CLI::App& verb, ShownShader& shown);
// Returns the shader's material with its settings and with room for the renderer's arguments, or
// std::nullopt if --shader is not given. Throws InputError.
std::optional<Material> shown_material(const ShownShader& shown, const std::string& verb);
// Adds this material to the materials that the job shows.
void show_shader(const ShownShader& shown, const std::string& verb, render::Job& job);

}  // namespace brdf::cli
