#include "render/gpu/fragment_code.h"

#include <algorithm>
#include <shaderc/shaderc.hpp>

#include "io/files/error.h"
#include "render/gpu/reflectance_glsl.h"

namespace brdf::render {

void require_shader(const Reflectance& reflectance) {
  const ReflectanceInfo& info = reflectance.info();
  if (const std::string obstacle = shader_obstacle(info); !obstacle.empty())
    throw InputError(std::string(info.name) + " " + obstacle + ": the Vulkan renderer cannot draw it");
}

void ReflectanceNumbers::add(const Reflectance& reflectance) {
  if (catalogue_index(reflectance) < 0 && std::ranges::find(others_, reflectance) == others_.end())
    others_.push_back(reflectance);
}

int ReflectanceNumbers::of(const Reflectance& reflectance) const {
  if (const int index = catalogue_index(reflectance); index >= 0) return index;
  const auto found = std::ranges::find(others_, reflectance);
  return int(catalogue().size()) + int(found - others_.begin());
}

std::vector<std::uint32_t> compiled(const std::string& glsl, Stage stage, std::string_view whose) {
  shaderc::CompileOptions options;
  options.SetTargetEnvironment(shaderc_target_env_vulkan, shaderc_env_version_vulkan_1_3);
  options.SetOptimizationLevel(shaderc_optimization_level_performance);
  const std::string name(whose);
  const auto result = shaderc::Compiler().CompileGlslToSpv(
      glsl, stage == Stage::compute ? shaderc_compute_shader : shaderc_fragment_shader, name.c_str(),
      options);
  if (result.GetCompilationStatus() == shaderc_compilation_status_success)
    return {result.begin(), result.end()};
  const std::string words = result.GetErrorMessage();
  throw InputError(name + ": its GLSL does not compile: " + words.substr(0, words.find('\n')));
}

Spirv FragmentCode::of(const Reflectance& reflectance, int number) {
  if (catalogue_index(reflectance) >= 0) return of_catalogue_;
  std::vector<std::uint32_t>& code = others_[number];
  if (code.empty()) {
    const NumberedReflectance entry{number, reflectance};
    std::string text = text_;
    const auto put = [&](const std::string& place, const std::string& glsl) {
      const std::size_t at = text.find(place);
      if (at != std::string::npos) text.replace(at, place.size(), glsl);
    };
    put("#include \"brdf.glsl\"\n", reflectances_glsl({&entry, 1}));
    put("#include \"samplers.glsl\"\n", samplers_glsl({&entry, 1}));
    code = compiled(text, Stage::fragment, reflectance.info().name);
  }
  return code;
}

}  // namespace brdf::render
