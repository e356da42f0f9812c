// Functions in the styles that users write. Each is understood, or refused with a message that gives the
// remedy.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "brdf/integrals.h"
#include "tests/shader/texts.h"

namespace brdf::shader {
namespace {

using testing::HasSubstr;

std::vector<std::string> names(std::span<const ParameterInfo> table) {
  std::vector<std::string> out;
  for (const ParameterInfo& p : table) out.emplace_back(p.name);
  return out;
}

TEST(Style, VectorsWithParametersAndColours) {
  const auto shader = shader_of(kGgx);
  EXPECT_THAT(names(shader->info().weights), testing::ElementsAre("f0", "albedo"));
  EXPECT_THAT(names(shader->info().shape), testing::ElementsAre("roughness"));
  EXPECT_EQ(shader->info().shape[0].min, 0.05);
  // GGX of width 0.25 with Smith's masking in two factors and Schlick's F of f0 0.5, plus 0.5/pi, computed
  // by hand from the formula.
  const double h2 = 1, a2 = 0.0625, d = h2 * (a2 - 1) + 1,
               g = 2 * 0.5 / (0.5 + std::sqrt(a2 + (1 - a2) * 0.25));
  const double f = 0.5 + 0.5 * std::pow(0.5, 5);
  EXPECT_NEAR(value_at(shader, 60, 0, 60, 180), 0.5 / kPi + a2 / (kPi * d * d) * g * g * f / (4 * 0.25),
              1e-6);
}

TEST(Style, ExplorersFileHasItsBlocksAsParameters) {
  const auto shader = shader_of(R"(analytic
# two lobes
::begin parameters
color baseColor .82 .67 .16
float Ks 0 2 .1   # of the lobe
float n 1 1000 100
bool squared 0
::end parameters
::begin shader
vec3 BRDF(vec3 L, vec3 V, vec3 N, vec3 X, vec3 Y)
{
  float s = pow(max(0, dot(reflect(-L, N), V)), n);
  if (squared) s *= s;
  return baseColor / 3.14159265358979 + vec3(Ks * s);
}
::end shader
)",
                                {}, "two.brdf");
  EXPECT_THAT(names(shader->info().shape), testing::ElementsAre("n", "squared"));
  EXPECT_THAT(names(shader->info().weights), testing::ElementsAre("baseColor", "Ks"));
  EXPECT_TRUE(shader->info().fittable());
  EXPECT_NEAR(value_at(shader, 30, 0, 30, 180, 2), 0.16 / kPi + 0.1, 1e-7);
  EXPECT_NEAR(value_at(shader, 30, 0, 40, 180, 0),
              0.82 / kPi + 0.1 * std::pow(std::cos(degrees(10).radians()), 100), 1e-7);
}

TEST(Style, ProductsAreArguments) {
  const auto shader = shader_of(
      "float diffuse_brdf(float NdotL, float dotNV, float LoV, float k) { return NdotL + 10.0 * dotNV + "
      "100.0 * LoV; }");
  const double expected = std::cos(0.5) + 10 * std::cos(0.3) + 100 * std::cos(0.8);
  EXPECT_NEAR(value_at(shader, radians(0.5).degrees(), 0, radians(0.3).degrees(), 180), expected, 1e-9);
}

TEST(Style, StructsUniformsAndInputs) {
  const auto shader = shader_of(R"(
struct Light { vec3 color; vec3 direction; };
struct Surface { vec3 diffuseColor; float roughness; };
uniform float scale = 0.25;
in vec3 vNormal;
vec3 shadeBRDF(const in Light light, const in vec3 viewDir, const in Surface material) {
  return light.color * material.diffuseColor * scale * dot(vNormal, light.direction) * (1.0 + 0.0 * viewDir.x);
}
)");
  EXPECT_THAT(names(shader->info().weights), testing::Contains("diffuseColor"));
  EXPECT_NEAR(value_at(shader, 60, 0, 10, 0), 0.5 * 0.25 * 0.5, 1e-12);
}

TEST(Style, HlslWithABufferOfConstants) {
  const auto shader = shader_of(R"(
cbuffer Material : register(b0) { float gRoughness; float3 gBaseColor; };
float3 BRDF(float3 L, float3 V, float3 N) {
  float3 H = normalize(L + V);
  return lerp(gBaseColor, 0.5f.xxx, saturate(gRoughness)) * rsqrt(4.0) * dot(N, H);
}
)",
                                {}, "a.hlsl");
  EXPECT_THAT(names(shader->info().weights), testing::ElementsAre("gBaseColor"));
  EXPECT_NEAR(value_at(shader, 40, 0, 40, 180), 0.25, 1e-7);
}

TEST(Style, OfArraysAndMatricesTheNumbersThatAreRead) {
  const auto shader = shader_of(
      "cbuffer Frame { float4 gParams[4]; float4x4 gView; };\n"
      "float3 BRDF(float3 L, float3 V, float3 N) { return gParams[1].xxx * gView[2][1]; }",
      {.file = "", .parameters = {"gParams_4=0:3:2", "gView_9=0:1:0.25"}}, "a.hlsl");
  EXPECT_EQ(shader->info().weights.size() + shader->info().shape.size(), 2u);
  EXPECT_NEAR(value_at(shader, 40, 0, 40, 180), 0.5, 1e-12);
}

TEST(Style, TheCosineMayBeIn) {
  const std::string text = "float brdf(vec3 L, vec3 V, vec3 N) { return 0.25 * dot(N, L); }";
  EXPECT_NEAR(value_at(shader_of(text), 60, 0, 0, 0), 0.125, 1e-12);
  EXPECT_NEAR(value_at(shader_of(text, {.file = "", .returns = "f*cos_i"}), 60, 0, 0, 0), 0.25, 1e-12);
  EXPECT_NEAR(value_at(shader_of("//: returns f * cos_o\n" + text), 60, 0, 60, 0), 0.25, 1e-12);
}

TEST(Style, TheCommandLineWins) {
  const std::string text =
      "//: param k 0 1 0.5\nfloat first(vec3 L, vec3 V, float k) { return k; }\nfloat second(vec3 L, vec3 V, "
      "float k) { return 2.0 * k; }";
  const auto shader = shader_of(text, {.file = "", .parameters = {"k=1:4:2:log"}, .entry = "second"});
  const ParameterInfo k =
      shader->info().weights.empty() ? shader->info().shape[0] : shader->info().weights[0];
  EXPECT_EQ(k.min, 1);
  EXPECT_EQ(k.max, 4);
  EXPECT_TRUE(k.log_scale);
  EXPECT_EQ(value_at(shader, 10, 0, 20, 0), 4);
  EXPECT_THAT(refusal(text), HasSubstr("--entry NAME"));
}

TEST(Style, AFunctionMayShadowABuiltInOne) {
  const auto shader = shader_of(
      "\nvec3 reflect(vec3 I, vec3 N) { return 2.0 * dot(I, N) * N - I; }\n"
      "float brdf(vec3 L, vec3 V, vec3 N) { return max(0.0, dot(reflect(L, N), V)); }");
  EXPECT_NEAR(value_at(shader, 30, 0, 30, 180), 1, 1e-12);
  EXPECT_THAT(shader->function().notes.front(), HasSubstr("line 2: reflect() shadows the built-in"));
}

TEST(Style, NeighboursOfASnippetAreKnown) {
  const auto shader = shader_of(
      "vec3 BRDF_Lambert(const in vec3 diffuseColor) { return RECIPROCAL_PI * diffuseColor; }\n"
      "vec3 brdf(vec3 lightDir, vec3 viewDir, vec3 normal, vec3 c) { return saturate(2.0) * BRDF_Lambert(c); "
      "}");
  EXPECT_NEAR(value_at(shader, 30, 0, 30, 180), 0.5 / kPi, 1e-7);
}

TEST(Style, TheValueMayBeAMemberOrAnArgument) {
  // A closure that the function fills, as in the generated code of material libraries. Its response
  // includes the cosine.
  const auto closure = shader_of(R"(
struct Closure { int kind; vec3 L; vec3 V; vec3 N; float occlusion; };
struct BSDF { vec3 response; vec3 throughput; };
void sheet_bsdf(Closure c, float weight, vec3 color, inout BSDF bsdf) {
  bsdf.throughput = vec3(0.0);
  bsdf.response = color * weight * c.occlusion * dot(c.N, c.L);
}
)");
  EXPECT_NEAR(value_at(closure, 60, 0, 10, 0), 0.5 * 0.5 * 0.5, 1e-12);
  EXPECT_THAT(closure->function().notes, testing::Contains(HasSubstr("bsdf.response")));
  EXPECT_THAT(closure->function().notes, testing::Contains(HasSubstr("--returns 'f*cos_i'")));
  // Separate diffuse and specular outputs, and a density in addition.
  const auto parts = shader_of(
      "void EvaluateBRDF(in float3 lightDir, in float3 viewDir, float k, out float3 diffuse, out float3 "
      "specular, out "
      "float pdf)\n{ diffuse = k; specular = 0.25; pdf = 1 / k; }",
      {}, "a.hlsl");
  EXPECT_NEAR(value_at(parts, 60, 0, 10, 0), 0.75, 1e-12);
  EXPECT_EQ(parts->info().shape.size() + parts->info().weights.size(), 1u);
  // A struct as the return value.
  const auto lighting = shader_of(
      "struct Lit { vec3 Diffuse; vec3 Specular; vec3 Transmission; };\n"
      "Lit DefaultBxDF(vec3 N, vec3 V, vec3 L) { return Lit(vec3(0.1), vec3(0.2), vec3(4.0)); }");
  EXPECT_NEAR(value_at(lighting, 60, 0, 10, 0), 0.3, 1e-7);
  EXPECT_THAT(refusal("struct Two { vec3 a; vec3 b; };\nTwo brdf(vec3 L, vec3 V) { return Two(L, V); }",
                      {.file = "", .entry = "brdf"}),
              HasSubstr("gives several values (a, b)"));
}

TEST(Style, DirectionsMayBeGlobalAndSpellTheirSpace) {
  const auto shader = shader_of(R"(
struct Light { vec4 colorIntensity; vec3 l; float NoL; mat4 shadow; };
vec3 shading_view; vec3 shading_normal;
vec4 tint;
vec3 surfaceShading(const Light light, vec3 normalWS, vec4 base) {
  return base.rgb * light.colorIntensity.w * light.NoL * dot(shading_view, shading_normal) * normalWS.z;
}
)");
  EXPECT_NEAR(value_at(shader, 60, 0, 60, 0), 0.5 * 0.5 * 0.5, 1e-12);
}

TEST(Style, OneOfAnEnginesSuffixesMayBeEitherLanguage) {
  EXPECT_NEAR(
      value_at(shader_of("vec3 brdf(vec3 L, vec3 V) { return vec3(0.5); }", {}, "a.fx"), 10, 0, 10, 0), 0.5,
      1e-12);
  EXPECT_NEAR(
      value_at(shader_of("float3 brdf(float3 L, float3 V) { return 0.5; }", {}, "a.txt"), 10, 0, 10, 0), 0.5,
      1e-12);
}

TEST(Style, WhatMainCallsIsFound) {
  const auto shader = shader_of(
      "varying vec3 vNormal;\nuniform vec3 uDiffuse;\nvec3 shade(vec3 n, vec3 l, vec3 v) { return uDiffuse; "
      "}\n"
      "void main() { gl_FragColor = vec4(shade(vNormal, vNormal, vNormal), 1.0); }");
  EXPECT_NEAR(value_at(shader, 10, 0, 10, 0), 0.5, 1e-12);
}

TEST(Style, KnownViolationsAreDeclared) {
  const auto shader =
      shader_of("//: violates energy at 80 twice what arrives\nfloat brdf(vec3 L, vec3 V) { return 0.7; }");
  ASSERT_EQ(shader->info().violations.size(), 1u);
  EXPECT_EQ(shader->info().violations[0].check, "energy");
  EXPECT_EQ(shader->info().violations[0].theta, 80);
  EXPECT_EQ(shader->info().violations[0].statement, "twice what arrives");
  EXPECT_EQ(shader->info().violations[0].value, 0);
  const auto stated =
      shader_of("//: violates energy up to 2.1 at 80 bright\nfloat brdf(vec3 L, vec3 V) { return 0.7; }");
  EXPECT_EQ(stated->info().violations[0].value, 2.1);
  EXPECT_EQ(stated->info().violations[0].theta, 80);
  EXPECT_EQ(stated->info().violations[0].statement, "bright");
  EXPECT_THAT(refusal("//: violates\nfloat brdf(vec3 L, vec3 V) { return 0.7; }"),
              HasSubstr("violates must be followed by the name of a check"));
}

TEST(Style, AScriptsShadersStandInBackticks) {
  const auto shader = shader_of(
      "export default /* glsl */`\nfloat schlick(float f0, float dotVH) { return f0 + (1.0 - f0) * pow5(1.0 "
      "- dotVH); }\n"
      "vec3 BRDF_Lit(const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 "
      "tint) {\n"
      "  return saturate(tint) * RECIPROCAL_PI * pow2(2.0);\n}\n`;\n",
      {}, "chunk.glsl.js");
  EXPECT_NEAR(value_at(shader, 30, 0, 30, 180), 0.5 / kPi * 4, 1e-6);
  EXPECT_THAT(
      shader->function().notes,
      testing::Contains(HasSubstr("RECIPROCAL_PI, saturate, pow2, pow5, which the file does not define")));
}

TEST(Style, FunctionsThatDoNotCompileAreLeftOut) {
  // A texture in main() without a declaration, a type that another file defines, and a function that
  // depends on this type.
  const std::string text =
      "float helper(float x) { return 2.0 * x; }\n"
      "vec3 eval_lobe(vec3 wi_local, vec3 wo_local, vec3 tint) { return tint * helper(0.25); }\n"
      "float trouble(Other o) { return o.x; }\n"
      "float more_trouble(vec3 wi_local, vec3 wo_local) { return trouble(1.0); }\n"
      "float pdf_lobe(vec3 wi_local, vec3 wo_local) { return 1.0; }\n"
      "void main() { gl_FragColor = texture2D(nowhere, vec2(0.0)); }\n";
  const auto shader = shader_of(text);
  EXPECT_NEAR(value_at(shader, 30, 0, 30, 180), 0.25, 1e-12);
  EXPECT_THAT(shader->function().notes,
              testing::Contains(testing::AllOf(HasSubstr("omitted trouble(), more_trouble(), main()"),
                                               HasSubstr("test.glsl:3: the type Other is not defined"))));
  // If such a function is requested, the refusal gives the function's own error. A function that does not
  // compile but is named as a reflectance is refused as well; its part is used only on request.
  EXPECT_THAT(refusal(text, {.file = "", .entry = "trouble"}), HasSubstr("test.glsl:3: the type Other"));
  const std::string part =
      "float lobe(vec3 L, vec3 V) { return 3.0; }\n"
      "float sheet_bsdf(vec3 L, vec3 V, Closure c) { return lobe(L, V) / 10.0; }\n";
  EXPECT_THAT(refusal(part),
              testing::AllOf(HasSubstr("test.glsl:2: the type Closure is not defined"),
                             HasSubstr("use --entry to select a function that is called there: lobe")));
  EXPECT_NEAR(value_at(shader_of(part, {.file = "", .entry = "lobe"}), 30, 0, 30, 180), 3, 1e-12);
}

TEST(Style, VulkansLayoutsAndComputeShaders) {
  const auto shader = shader_of(
      "#version 450\nlayout(local_size_x = 64) in;\n"
      "layout(std430, set = 0, binding = 0) readonly buffer Dirs { vec4 dirs[]; };\n"
      "layout(push_constant) uniform Push { float k; vec3 tint; } pc;\n"
      "layout(constant_id = 3) const int kind = 2;\n"
      "vec3 brdf(vec3 wi, vec3 wo) { return kind == 2 ? pc.tint * pc.k : vec3(7.0); }\n"
      "void main() { dirs[gl_GlobalInvocationID.x]; }\n",
      {}, "a.comp");
  EXPECT_NEAR(value_at(shader, 30, 0, 30, 180), 0.25, 1e-12);
}

TEST(Style, UnitysLabHoldsAShader) {
  const auto shader = shader_of(
      "Shader \"Own/Plain\" {\n  Properties { _Tint (\"Tint\", Color) = (1,1,1,1) }\n  SubShader { Pass {\n  "
      "CGPROGRAM\n"
      "  half3 _Tint;\n  half3 Shade_BRDF(half3 normalWS, half3 lightDirWS, half3 viewDirWS) { return _Tint "
      "* UNITY_INV_PI; "
      "}\n  ENDCG\n  } }\n}\n",
      {}, "plain.shader");
  EXPECT_NEAR(value_at(shader, 30, 0, 30, 180), 0.5 / kPi, 1e-6);
}

TEST(Energy, AClampedProductReflectsMoreThanItReceives) {
  const auto albedo = [](const std::string& s) {
    const auto shader = shader_of(energy_preserving(s));
    return directional_albedo(shader->material(shader).terms[0], 0, degrees(85), {}, {}).value;
  };
  EXPECT_NEAR(albedo("max(LdotV, 0.0)"), 1.1429, 1e-4);
  EXPECT_NEAR(albedo("LdotV"), 1.00000, 5e-6);
}

TEST(Style, AColourIsAParameterInEitherOrderOfWords) {
  const std::string code = "\nvec3 brdf(vec3 L, vec3 V, vec3 tint) { return tint; }";
  for (const char* note : {"//: color tint 0.8 0.6 0.1", "//: param tint color 0.8 0.6 0.1"}) {
    const auto shader = shader_of(note + code);
    EXPECT_NEAR(value_at(shader, 10, 0, 20, 0, 1), 0.6, 1e-6) << note;
    EXPECT_NEAR(value_at(shader, 10, 0, 20, 0, 2), 0.1, 1e-6) << note;
  }
}

}  // namespace
}  // namespace brdf::shader
