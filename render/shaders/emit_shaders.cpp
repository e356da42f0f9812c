// Build step that writes shader code into a folder. The includes of the shaders are brdf.glsl (all forms of
// the catalogue, traced), samplers.glsl (their samplers), layout.glsl (the limits and enumerators shared
// with C++), rules.glsl (the texture rule and the display's colours, traced) and fresnel.glsl (in double, for
// paths). The other outputs are the proof's compute shader, negative controls without `precise`, and the
// sources that are compiled again at run time.
#include <cstdio>
#include <fstream>

#include "brdf/fresnel.h"
#include "io/colour/traced_power.h"
#include "io/light/studio.h"
#include "io/page/hatching.h"
#include "render/compare/arrange.h"
#include "render/gpu/gpu_layout.h"
#include "render/gpu/reflectance_glsl.h"
#include "render/light/blurred_light.h"
#include "render/light/points.h"
#include "render/scene/display_rule.h"
#include "render/scene/texture_rule.h"

namespace brdf {

// A function that display_rule.h requires of a scalar, as a function of GLSL.
Traced log_10(Traced x) {
  return Traced::from_node(Trace::current().add({Trace::Type::float_type, "log2", {x.node()}})) /
         Traced(std::log2(10.0));
}

namespace render {
namespace {

// Returns one `case` per enumerator of a function that returns value(enumerator), a list of values that are
// stored in `result`.
template <class Enum, class Value>
std::string switch_over(const std::string& argument, int count, const std::string& result, Value value) {
  std::string text = "  switch (" + argument + ") {\n";
  for (int k = 0; k < count; ++k) {
    Trace trace;
    const Trace::Scope scope(trace);
    std::vector<int> nodes;
    for (const Traced& v : value(Enum(k))) nodes.push_back(v.node());
    text += "  case " + std::to_string(k) + ": {\n" + trace.statements(nodes, result, true) + "  }\n";
  }
  return text + "  }\n";
}

std::string traced_rules() {
  const auto in = [](const char* name) { return Traced::input(name); };
  std::string text = "float driven(int rule, float own, float albedo, float roughness, float metallic) {\n" +
                     switch_over<Rule>("rule", kRuleCount, "return %0;",
                                       [&](Rule rule) {
                                         return std::array{driven(rule, in("own"), in("albedo"),
                                                                  in("roughness"), in("metallic"))};
                                       }) +
                     "  return own;\n}\n";
  text +=
      "vec3 tone_curve(int tone_map, vec3 linear) {\n" +
      switch_over<ToneMap>("tone_map", int(kNames<ToneMap>.size()), "return vec3(%0, %1, %2);",
                           [&](ToneMap map) {
                             return tone_curve<Traced>(map, {in("linear.r"), in("linear.g"), in("linear.b")});
                           }) +
      "  return linear;\n}\n";
  Trace trace;
  const Trace::Scope scope(trace);
  const auto [r, g, b] = false_color_of(in("relative"));
  text +=
      detail::glsl_function("vec3 false_color(float relative)", {r, g, b}, "return vec3(%0, %1, %2);", true);
  const auto [plus_r, plus_g, plus_b] = signed_color_of(in("relative"));
  text += detail::glsl_function("vec3 signed_color(float relative)", {plus_r, plus_g, plus_b},
                                "return vec3(%0, %1, %2);", true);
  text += detail::glsl_function("float sky_color(float horizon, float zenith, float up)",
                                {sky_color(in("horizon"), in("zenith"), in("up"))}, "return %0;", true);
  text += detail::glsl_function("float backdrop_color(float bottom, float top, float height)",
                                {backdrop_color(in("bottom"), in("top"), in("height"))}, "return %0;", true);
  text += detail::glsl_function("float light_beside_ball(float height, float radius, float distance2)",
                                {io::studio::light_beside_ball(in("height"), in("radius"), in("distance2"))},
                                "return %0;", true);
  return text;
}

// Returns the library's Fresnel reflectance in double. All constants of the formula are whole numbers and
// halves, besides a floor of sums, which no ray that meets a facet reaches: their float literals stand for
// the same values in double.
std::string fresnel() {
  Trace trace;
  const Trace::Scope scope(trace);
  const Traced reflectance = fresnel_dielectric(Traced::input("index"), Traced::input("cosine"));
  std::string text = detail::glsl_function("float fresnel_dielectric(float index, float cosine)",
                                           {reflectance}, "return %0;", true);
  for (std::size_t at = 0; (at = text.find("float", at)) != std::string::npos;) text.replace(at, 5, "double");
  return text;
}

// Returns the shader without its words `precise`.
std::string unprecise(std::string text) {
  constexpr std::string_view kWord = "precise ";
  for (std::size_t at = 0; (at = text.find(kWord, at)) != std::string::npos;) text.erase(at, kWord.size());
  return text;
}

template <class Enum>
std::string enumerators(const std::string& prefix) {
  std::string text;
  for (std::size_t k = 0; k < kNames<Enum>.size(); ++k)
    text += "const int " + prefix + "_" + std::string(kNames<Enum>[k]) + " = " + std::to_string(k) + ";\n";
  return text;
}

std::string layout() {
  const auto constant = [](const char* name, std::size_t value) {
    return "const int " + std::string(name) + " = " + std::to_string(value) + ";\n";
  };
  return constant("kMostLights", kMostLights) + constant("kMostItems", kMostItems) +
         constant("kMostWeights", kMostWeights) + constant("kTargetCount", kTargetCount) +
         constant("kRemainderScale", kRemainderScale) + constant("kFourthShape", kFourthShape) +
         constant("kHatchPeriod", io::kHatchPeriod) + constant("kHatchDark", io::kHatchDark) +
         constant("kHatchBright", io::kHatchBright) + constant("kBackdrop", kBackdrop) +
         constant("kPointDimensions", kPointDimensions) + constant("kLightSquare", kLightSquare) +
         constant("kBlurredHeight", kBlurredHeight) + constant("kBlurredLevels", kBlurredLevels) +
         "const float kNoFloor = " + std::to_string(kNoFloor) + ";\n" +
         "const float kLeastFacing = " + std::to_string(kLeastFacing) + ";\n" +
         "const float kLeastSeen = " + std::to_string(kLeastSeen) + ";\n" + enumerators<Shading>("shading") +
         enumerators<ToneMap>("tone_map") + enumerators<Display>("display") + enumerators<Target>("target") +
         enumerators<TextureSlot>("map");
}

// Returns a shader with its includes expanded, except brdf.glsl and samplers.glsl, which are inserted
// later.
std::string expanded(const std::vector<std::string>& folders, const std::string& name) {
  std::ifstream in;
  for (const std::string& folder : folders) {
    in.open(folder + "/" + name);
    if (in) break;
    in.clear();
  }
  std::string text, line;
  while (std::getline(in, line)) {
    const bool include = line.starts_with("#include \"") && line.find("brdf.glsl") == std::string::npos &&
                         line.find("samplers.glsl") == std::string::npos;
    text += include ? expanded(folders, line.substr(10, line.find('"', 10) - 10)) : line + "\n";
  }
  return text;
}

bool write(const std::string& path, const std::string& text) {
  std::ofstream out(path);
  return !text.empty() && bool(out << text) && bool(out.flush());
}

bool write_all(const std::string& sources, const std::string& folder) {
  const std::vector<NumberedReflectance> list = numbered_catalogue();
  if (!write(folder + "/brdf.glsl", reflectances_glsl(list)) ||
      !write(folder + "/samplers.glsl", samplers_glsl(list)) ||
      !write(folder + "/rules.glsl", traced_rules()) || !write(folder + "/layout.glsl", layout()) ||
      !write(folder + "/proof.comp", proof_glsl(list)) ||
      !write(folder + "/proof_unprecise.comp", proof_glsl(list, {.precise = false})) ||
      !write(folder + "/fresnel.glsl", fresnel()) ||
      !write(folder + "/paths_unprecise.comp", unprecise(expanded({sources, folder}, "paths.comp"))))
    return false;
  for (const char* shader : {"lighting.frag", "forward.frag", "environment.frag"})
    if (!write(folder + "/" + shader + ".text.inc",
               "R\"glsl(" + expanded({sources, folder}, shader) + ")glsl\"\n"))
      return false;
  return true;
}

}  // namespace
}  // namespace render
}  // namespace brdf

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: emit_shaders SOURCES FOLDER\n");
    return 2;
  }
  if (brdf::render::write_all(argv[1], argv[2])) return 0;
  std::fprintf(stderr, "emit_shaders: cannot write into %s\n", argv[2]);
  return 1;
}
