#include "io/material/shader_texts.h"

#include "io/files/text.h"
#include "io/material/cpp_text.h"
#include "io/material/glsl.h"
#include "io/material/shader_words.h"

namespace brdf::io {
namespace {

std::string hlsl(std::string text) {
  replace_all(text, "vec3(0.0)", "vec3(0.0, 0.0, 0.0)");
  return with_words(text, [](std::string word) -> std::string {
    if (word == "vec3") return "float3";
    if (word == "floatBitsToUint") return "asuint";
    if (word == "uintBitsToFloat") return "asfloat";
    if (word == "atan") return "atan2";  // atan is only used with a sine and a cosine
    return word;
  });
}

// Returns the line of a slider: type, name and range.
std::string slider(const ParameterInfo& p, bool weight, const std::vector<double>& of_channels) {
  if (!weight)
    return "float " + std::string(p.name) + " " + to_text(p.min) + " " + to_text(p.usual_max) + " " +
           to_text(of_channels[0]) + "\n";
  std::string line = "color " + std::string(p.name);
  for (std::size_t c = 0; c < 3; ++c) line += " " + to_text(of_channels[of_channels.size() == 1 ? 0 : c]);
  return line + "\n";
}

std::string explorer(const Material& material, const std::string& functions, bool with_material) {
  std::string sliders, call = "brdf_material(wi, wo)";
  if (!with_material) {
    const Term& term = material.terms[0];
    const ReflectanceInfo& form = info(term.form);
    call = "brdf_eval_" + std::string(form.name) + "(wi, wo";
    const auto add = [&](const ParameterInfo& p, std::size_t k, bool weight,
                         const std::vector<std::vector<double>>& sets) {
      std::vector<double> values;
      for (const std::vector<double>& set : sets) values.push_back(set[k]);
      sliders += slider(p, weight, values);
      call += ", " + std::string(p.name);
    };
    for (std::size_t k = 0; k < form.shape.size(); ++k) add(form.shape[k], k, false, term.shape);
    for (std::size_t k = 0; k < form.weights.size(); ++k) add(form.weights[k], k, true, term.weights);
    call += ")";
  }
  return "analytic\n::begin parameters\n" + sliders + "::end parameters\n::begin shader\n" + functions +
         "vec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y) {\n"
         "  vec3 wi = vec3(dot(L, X), dot(L, Y), dot(L, N)), wo = vec3(dot(V, X), dot(V, Y), dot(V, N));\n"
         "  return " +
         call + ";\n}\n::end shader\n";
}

}  // namespace

std::string shader_text(const Material& material, ShaderLanguage language, bool with_material,
                        const std::string& name, bool builtin_kernels) {
  GlslContent content{.material = with_material, .whole = false, .builtin_kernels = builtin_kernels};
  switch (language) {
    case ShaderLanguage::hlsl:
      content.name = name;
      content.guarded = true;
      return hlsl(glsl_source(material, content));
    case ShaderLanguage::cpp:
      return cpp_text(material, with_material, name, builtin_kernels);
    case ShaderLanguage::explorer:
      return explorer(material, glsl_source(material, content), with_material);
  }
  return {};
}

}  // namespace brdf::io
