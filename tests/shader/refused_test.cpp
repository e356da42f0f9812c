// Shaders that are refused, and the message for each.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>

#include "tests/shader/texts.h"

namespace brdf::shader {
namespace {

using testing::HasSubstr;

// A macro that expands to 2^39 terms.
const std::string kExpanding = [] {
  std::string text = "#define A0 1.0\n";
  for (int k = 1; k < 40; ++k) {
    const std::string before = " A" + std::to_string(k - 1);
    text += "#define A" + std::to_string(k) + before + "+" + before + "\n";
  }
  return text + "float brdf(vec3 L, vec3 V) { return A39; }";
}();

TEST(Refused, OtherLanguagesByName) {
  EXPECT_THAT(refusal("fn brdf(L: vec3<f32>, V: vec3<f32>) -> vec3<f32> { return L; }"),
              HasSubstr("is WGSL"));
  EXPECT_THAT(refusal("#include <metal_stdlib>\nfloat3 brdf(float3 L, float3 V) { return L; }"),
              HasSubstr("Metal"));
  EXPECT_THAT(refusal("shader a(output closure color c = 0) { c = diffuse(N); }"),
              HasSubstr("Open Shading Language"));
  EXPECT_THAT(refusal("shader_type spatial;\nvoid light() { DIFFUSE_LIGHT += vec3(1.0); }"),
              HasSubstr("Godot"));
  EXPECT_THAT(refusal("glm::vec3 brdf(glm::vec3 L, glm::vec3 V) { return L; }"), HasSubstr("C++"));
}

TEST(Refused, AParameterThatTheCodeDeclaresNowhere) {
  const std::string note = "//: param shine 0 1 0.5\n";
  EXPECT_THAT(refusal(note + "float brdf(vec3 L, vec3 V) { return shine; }"),
              HasSubstr("line 1 makes it a parameter: declare it, as in `uniform float shine;`"));
  EXPECT_THAT(refusal("//: color tint 1 1 1\nvec3 brdf(vec3 L, vec3 V) { return tint; }"),
              HasSubstr("as in `uniform vec3 tint;`"));
  EXPECT_EQ(refusal(note + "uniform float shine;\nfloat brdf(vec3 L, vec3 V) { return shine; }"), "accepted");
}

TEST(Refused, WithTheSentenceThatHelps) {
  const std::string only_main = "#version 330 core\nout vec4 c;\nvoid main() { c = vec4(1.0); }\n";
  EXPECT_THAT(refusal(only_main), HasSubstr("test.glsl: has main() and no function brdf"));
  EXPECT_THAT(refusal(only_main), HasSubstr("//: entry NAME"));
  EXPECT_THAT(refusal(only_main, {.file = "", .entry = "main"}),
              testing::AllOf(HasSubstr("main() has no directions"), HasSubstr("//: entry NAME")));
  EXPECT_THAT(
      refusal("uniform sampler2D lut;\nfloat brdf(vec3 L, vec3 V) {\n return texture(lut, L.xy).r; }"),
      HasSubstr("test.glsl:3: reads the texture lut: give its texels with --texture lut=FILE.exr, or use a "
                "parameter"));
  EXPECT_THAT(refusal("float brdf(vec3 L, vec3 V) {\n if (L.x > 0.1) discard;\n return 1.0; }"),
              HasSubstr("test.glsl:2: discards the pixel"));
  EXPECT_THAT(refusal("float brdf(vec3 L, vec3 V) {\n return dott(L, V); }"),
              HasSubstr("test.glsl:2: 'dott'"));
  EXPECT_THAT(refusal("mat3 brdf(vec3 L, vec3 V) { return mat3(1.0); }", {.file = "", .entry = "brdf"}),
              HasSubstr("a reflectance is a float or a vec3"));
  EXPECT_THAT(refusal(kGgx, {.file = "", .parameters = {"rough=0:1"}}),
              HasSubstr("--param rough: is not an argument, uniform or global variable of"));
  EXPECT_THAT(refusal(kGgx, {.file = "", .parameters = {"roughness=1:0"}}),
              HasSubstr("the minimum is above the maximum"));
  EXPECT_THAT(refusal(kGgx, {.file = "", .entry = "shade"}),
              HasSubstr("has no function shade (the file has "));
  EXPECT_THAT(refusal(kGgx, {.file = "", .returns = "f*cos"}),
              HasSubstr("must be one of f, f*cos_i, f*cos_o"));
  EXPECT_THAT(refusal("//: parameter a 0 1 0\nfloat brdf(vec3 L, vec3 V) { return 1.0; }"),
              HasSubstr("test.glsl:1: //: parameter: must be param"));
  EXPECT_THAT(refusal("::begin parameters\nfloat a 0\n::end parameters\n", {}, "a.brdf"),
              HasSubstr("a.brdf:2: must be NAME MIN MAX DEFAULT"));
  EXPECT_THAT(refusal(std::string(300, '(')), HasSubstr("nested too deeply"));
  EXPECT_THAT(refusal("float brdf(vec3 L, vec3 V) { return dFdx(L.x); }"),
              HasSubstr("screen-space derivatives"));
}

TEST(Refused, AFileOutsideTheShadersFolder) {
  const auto folder = std::filesystem::path(testing::TempDir()) / "brdf_shader_includes";
  std::filesystem::create_directories(folder / "inside");
  std::ofstream(folder / "outside.glsl") << "float secret() { return 1.0; }\n";
  std::ofstream(folder / "inside" / "part.glsl") << "float part(float x) { return 2.0 * x; }\n";
  const auto read = [&](const std::string& include) {
    std::ofstream(folder / "inside" / "a.glsl")
        << "#include \"" << include << "\"\nfloat brdf(vec3 L, vec3 V, float k) { return part(k); }\n";
    return load_shader(ShaderChoice{(folder / "inside" / "a.glsl").string()});
  };
  EXPECT_EQ(value_at(read("part.glsl"), 10, 0, 10, 0), 1);
  // A path relative to a folder further up, as libraries write it.
  EXPECT_EQ(value_at(read("library/inside/part.glsl"), 10, 0, 10, 0), 1);
  // An include that is not needed is left out.
  std::ofstream(folder / "inside" / "b.glsl")
      << "#include \"unneeded.glsl\"\nfloat brdf(vec3 L, vec3 V, float k) { return k; }\n";
  const auto without = load_shader(ShaderChoice{(folder / "inside" / "b.glsl").string()});
  EXPECT_EQ(value_at(without, 10, 0, 10, 0), 0.5);
  EXPECT_THAT(
      without->function().notes,
      testing::Contains(HasSubstr("'unneeded.glsl' is not a file of the shader's own folder; omitted")));
  for (const std::string name : {"../outside.glsl", "/etc/passwd", "missing.glsl"}) {
    try {
      read(name);
      ADD_FAILURE() << name;
    } catch (const InputError& e) {
      EXPECT_THAT(e.what(), HasSubstr("is not a file of the shader's own folder"));
    }
  }
  std::filesystem::remove_all(folder);
}

TEST(Refused, WhatAsksForMoreThanItsShare) {
  EXPECT_THAT(refusal(kExpanding), HasSubstr("the shader compiler needs more than"));
  std::string calls = "float f0(float x) { return sin(x) + x; }\n";
  for (int k = 1; k < 30; ++k) {
    const std::string before = "f" + std::to_string(k - 1);
    calls +=
        "float f" + std::to_string(k) + "(float x) { return " + before + "(x) * " + before + "(x + 1.0); }\n";
  }
  EXPECT_THAT(refusal(calls + "float brdf(vec3 L, vec3 V) { return f29(L.x); }"),
              HasSubstr("has more than 200000 operations"));
}

TEST(Compiler, TakesManyTextsAndGoesOnAfterOneThatEndsIt) {
  Compiler compiler;
  const auto value = [&](const std::string& text) {
    const auto shader = std::make_shared<const ShaderReflectance>(
        make_function(parse_source("test.glsl", text), {}, compiler));
    return value_at(shader, 10, 0, 10, 0);
  };
  for (int k = 1; k <= 20; ++k)
    EXPECT_EQ(value("float brdf(vec3 L, vec3 V) { return " + std::to_string(k) + ".0; }"), k);
  EXPECT_THROW(value("float brdf(vec3 L, vec3 V) { return missing; }"), InputError);
  EXPECT_THROW(value(kExpanding), InputError);
  EXPECT_EQ(value("float brdf(vec3 L, vec3 V) { return 5.0; }"), 5);
}

}  // namespace
}  // namespace brdf::shader
