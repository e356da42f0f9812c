// --shader in the verbs that show: render and view.
#pragma once

#include "cli/options/shader_options.h"
#include "render/job.h"

namespace brdf::cli {

struct ShownShader {
  ShaderOptions shader;
  std::vector<std::string> set;
};

// --shader, what says how to read it, and --set.
void add_shown_shader(CLI::App& verb, ShownShader& shown);
// The shader's material with its settings, with room for the renderer's arguments; nothing where --shader is
// not given. Throws InputError.
std::optional<Material> shown_material(const ShownShader& shown, const std::string& verb);
// That material among those that the job shows.
void show_shader(const ShownShader& shown, const std::string& verb, render::Job& job);

}  // namespace brdf::cli
