// Exported shaders are read back: each operation and each parameter has its value in every language.
#include <gtest/gtest.h>

#include "brdf/targets.h"
#include "io/material/glsl.h"
#include "io/material/shader_texts.h"
#include "shader/operation_texts.h"
#include "tests/shader/one_operation.h"

namespace brdf::shader {
namespace {

using io::ShaderLanguage;

constexpr std::pair<ShaderLanguage, const char*> kReadLanguages[] = {{ShaderLanguage::glsl, "glsl"},
                                                                     {ShaderLanguage::glsl_es, "es.glsl"},
                                                                     {ShaderLanguage::explorer, "brdf"},
                                                                     {ShaderLanguage::hlsl, "hlsl"}};

// Returns the shader of the exported text.
std::shared_ptr<const ShaderReflectance> read_again(const Material& material, ShaderLanguage language,
                                                    const std::string& ending, bool with_material = false) {
  const bool es = language == ShaderLanguage::glsl_es;
  const std::string text =
      es || language == ShaderLanguage::glsl
          ? io::glsl_source(
                material, {.material = with_material, .dialect = es ? GlslDialect::es : GlslDialect::vulkan})
          : io::shader_text(material, language, with_material, "x");
  return shader_of(text, {}, "again." + ending);
}

const Vec3<float> kExportedLight{0.6f, 0, 0.8f}, kExportedViewer{-0.48f, 0.36f, 0.8f};

// In a text for browsers these kernels read a uniform. No program in float contains them.
bool is_written(Op op, ShaderLanguage language) {
  return language != ShaderLanguage::glsl_es || (op != Op::log1p && op != Op::erfcx && op != Op::angle);
}

// Returns how many of the languages were read.
int expect_operation(Op op, const std::shared_ptr<const ShaderReflectance>& shader) {
  const std::array<float, 3> own = values_in_float(shader->material(shader), kExportedLight, kExportedViewer);
  int read = 0;
  for (const auto& [language, ending] : kReadLanguages) {
    if (!is_written(op, language)) continue;
    const auto again = read_again(shader->material(shader), language, ending);
    const std::array<float, 3> values =
        values_in_float(again->material(again), kExportedLight, kExportedViewer);
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_TRUE(is_same_value(own[c], values[c]))
          << ending << ' ' << int(op) << " (" << text_of(op, language) << ") channel " << c << ": " << own[c]
          << ' ' << values[c];
    ++read;
  }
  return read;
}

TEST(ExportedShader, HasEveryOperationInEveryLanguage) {
  int read = 0;
  for_each_operation(1, [&](Op op, const std::shared_ptr<const ShaderReflectance>& shader, auto&) {
    read += expect_operation(op, shader);
  });
  EXPECT_EQ(read, 4 * (int(Op::count) - 1) - 3);
}

// Parameters of all kinds. One name is a word of HLSL.
constexpr const char* kAllKinds = R"(
struct Surface { float rough; int steps; };
//: color base 0.8 0.2 0.1
//: param surface.rough 0.1 1 0.3
//: param surface.steps 1 5 3
//: param surface_rough 0 1 0.6
//: param float3 0 1 0.25
//: bool shiny 1
vec3 brdf(vec3 L, vec3 V, vec3 N, vec3 base, Surface surface, float surface_rough, float float3, bool shiny) {
  vec3 H = normalize(L + V);
  float sum = 0.0;
  for (int k = 0; k < surface.steps; ++k) sum += pow(max(dot(N, H), 0.0), float(k) + 1.0 / surface.rough);
  float rounded = round(3.0 * surface_rough) + atan(float3) + atan(L.y, L.x + 2.0);
  return shiny ? base / 3.14 + sum * 0.01 * rounded : base * base * 0.2 + vec3(rounded * float3);
})";

// Sets every parameter to a value that is not its default.
void set_others(Material& m) {
  const ReflectanceInfo& form = m.terms.front().form.info();
  for (std::size_t k = 0; k < form.shape.size(); ++k) {
    const ParameterInfo& p = form.shape[k];
    m.terms.front().shape.front()[k] = p.whole ? 2 : p.initial == 1 ? 0 : 0.5 * (p.initial + p.max);
  }
  for (std::size_t c = 0; c < m.channels.size(); ++c)
    for (std::size_t k = 0; k < form.weights.size(); ++k)
      m.terms.front().weights[c][k] = 0.15 + 0.2 * double(c) + 0.05 * double(k);
}

void expect_same_after_export(const std::shared_ptr<const ShaderReflectance>& shader) {
  for (const auto& [language, ending] : kReadLanguages) {
    const auto again = read_again(shader->material(shader), language, ending);
    for (const bool others : {false, true}) {
      Material own = shader->material(shader), read = again->material(again);
      if (others) set_others(own), set_others(read);
      if (others && read.channels.size() == own.channels.size()) {
        ASSERT_EQ(own.terms.front().shape.size(), read.terms.front().shape.size());
        read.terms.front().shape = own.terms.front().shape;
      }
      const std::array<float, 3> a = values_in_float(own, kExportedLight, kExportedViewer),
                                 b = values_in_float(read, kExportedLight, kExportedViewer);
      for (std::size_t c = 0; c < 3; ++c)
        EXPECT_TRUE(is_same_value(a[c], b[c])) << ending << others << ' ' << a[c] << ' ' << b[c];
    }
  }
}

TEST(ExportedShader, HasTheParametersOfItsSource) {
  expect_same_after_export(shader_of(kAllKinds));
  expect_same_after_export(load_shader({BRDF_SOURCE_DIR "/data/shaders/sound.glsl"}));
}

TEST(ExportedShader, KeepsTheNamesOfParameters) {
  const auto shader = load_shader({BRDF_SOURCE_DIR "/data/shaders/sound.glsl"});
  for (const auto& [language, ending] : kReadLanguages) {
    const auto again = read_again(shader->material(shader), language, ending);
    for (const char* weight : {"kd", "ks", "f0"}) EXPECT_GE(again->info().weight_index(weight), 0) << ending;
    EXPECT_GE(again->info().shape_index("roughness"), 0) << ending;
  }
}

// A form's text has the names of its table, which no language may reserve.
TEST(ExportedShader, HasTheNamesOfForms) {
  for (const auto list : {catalogue(), targets()})
    for (const Reflectance& form : list) {
      const ReflectanceInfo& info = form.info();
      const std::vector<std::string> names = io::argument_names(info.shape, info.weights);
      for (std::size_t k = 0; k < names.size(); ++k)
        EXPECT_EQ(names[k],
                  k < info.shape.size() ? info.shape[k].name : info.weights[k - info.shape.size()].name)
            << info.name;
    }
}

// The material of a shader is a function with its parameters as constants.
TEST(ExportedShader, IsAMaterial) {
  const auto shader = shader_of(kAllKinds);
  Material own = shader->material(shader);
  set_others(own);
  for (const auto& [language, ending] : kReadLanguages) {
    const auto again = read_again(own, language, ending, true);
    const std::array<float, 3> a = values_in_float(own, kExportedLight, kExportedViewer),
                               b = values_in_float(again->material(again), kExportedLight, kExportedViewer);
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_TRUE(is_same_value(a[c], b[c])) << ending << ' ' << a[c] << ' ' << b[c];
  }
}

}  // namespace
}  // namespace brdf::shader
