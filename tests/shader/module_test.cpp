// Shaders that another compiler has compiled to SPIR-V.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <glslang/SPIRV/spirv.hpp>
#include <spirv-tools/libspirv.hpp>

#include "shader/front/compile.h"
#include "tests/shader/texts.h"

namespace brdf::shader {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using Words = std::vector<std::uint32_t>;

// A sum of two lobes of different reach, in a file with a main of its own, as engines write it.
const std::string kOwn = R"(#version 450
layout(location = 0) in vec3 inL;
layout(location = 1) in vec3 inV;
layout(location = 0) out vec4 result;
layout(push_constant) uniform Numbers { float gloss; float base; } numbers;
float tail(float h, float g) { return g / (1.0 + (1.0 - h * h) * g * g); }
float brdf(vec3 L, vec3 V, vec3 N, float gloss, float base) {
  vec3 H = normalize(L + V);
  return base * 0.3 + 0.02 * tail(dot(N, H), 1.0 + 20.0 * gloss);
}
void main() { result = vec4(brdf(inL, inV, vec3(0.0, 0.0, 1.0), numbers.gloss, numbers.base)); }
)";

Words compiled(const std::string& text) {
  return compile(parse_source("own.glsl", text)).spirv;
}

std::string bytes_of(const Words& words, bool swapped = false) {
  std::string out;
  for (std::uint32_t word : words) {
    if (swapped) word = __builtin_bswap32(word);
    for (int byte = 0; byte < 4; ++byte) out += char(word >> 8 * byte & 255);
  }
  return out;
}

// Leaves out the instructions for which `is` returns true.
template <class Is>
Words without(const Words& words, Is&& is) {
  Words out(words.begin(), words.begin() + 5);
  for (std::size_t at = 5, length = 0; at < words.size(); at += length) {
    length = words[at] >> 16;
    if (!is(spv::Op(words[at] & 0xffff), std::span(words).subspan(at, length)))
      out.insert(out.end(), words.begin() + long(at), words.begin() + long(at + length));
  }
  return out;
}

Words without_names(const Words& words) {
  return without(words, [](spv::Op op, std::span<const std::uint32_t>) {
    return op == spv::OpName || op == spv::OpMemberName;
  });
}

std::string module_refusal(const std::string& bytes, const ShaderChoice& choice = {}) {
  return refusal(bytes, choice, "own.spv");
}

TEST(Module, GivesTheValuesOfItsText) {
  const auto from_text = shader_of(kOwn);
  for (const bool swapped : {false, true}) {
    const auto module = shader_of(bytes_of(compiled(kOwn), swapped), {}, "own.spv");
    EXPECT_EQ(module->info().shape.size() + module->info().weights.size(), 2u);
    for (const double theta : {0.0, 37.0, 81.0})
      EXPECT_EQ(value_at(module, theta, 20, 50, 170), value_at(from_text, theta, 20, 50, 170));
  }
}

// A module that has lost its names is chosen by the number of its function, and its arguments by place.
TEST(Module, WithoutNamesIsReadByNumberAndPlace) {
  const Words words = without_names(compiled(kOwn));
  const std::string why = module_refusal(bytes_of(words));
  ASSERT_THAT(
      why,
      AllOf(HasSubstr("own.spv: no function of this module has the name and the arguments of a reflectance"),
            HasSubstr("float %")));
  // The message lists the function with three vectors.
  const std::size_t at = why.find("(vec3 %");
  ASSERT_NE(at, why.npos) << why;
  const std::size_t name = why.rfind('%', at);
  const std::string number = why.substr(name, at - name);
  const ShaderChoice choice{.file = "", .entry = number + "(L, V, N, gloss, base)"};
  const auto module = shader_of(bytes_of(words), choice, "own.spv");
  EXPECT_EQ(value_at(module, 37, 20, 50, 170), value_at(shader_of(kOwn), 37, 20, 50, 170));
  std::vector<std::string> names;
  for (const ParameterInfo& p : module->info().shape) names.emplace_back(p.name);
  for (const ParameterInfo& p : module->info().weights) names.emplace_back(p.name);
  std::ranges::sort(names);
  EXPECT_EQ(names, (std::vector<std::string>{"base", "gloss"}));
}

TEST(Module, ThatBreaksTheRulesIsRefused) {
  const Words words = compiled(kOwn);
  EXPECT_THAT(module_refusal(bytes_of(words).substr(0, 402)), HasSubstr("ends within a word"));
  EXPECT_THAT(module_refusal(bytes_of({words.begin(), words.begin() + 60})),
              HasSubstr("own.spv: is not valid SPIR-V"));
  const Words unfinished =
      without(words, [](spv::Op op, std::span<const std::uint32_t>) { return op == spv::OpFunctionEnd; });
  EXPECT_THAT(module_refusal(bytes_of(unfinished)), HasSubstr("own.spv: is not valid SPIR-V"));
  Words unbound = words;
  unbound[3] = 3;  // the bound of all ids
  EXPECT_THAT(module_refusal(bytes_of(unbound)), HasSubstr("own.spv: is not valid SPIR-V"));
}

// k (L + V) / |L + V| . N / 4 as a function of values, exported as other compilers write libraries; and the
// same for N = z as an entry point without names, into which an optimiser has merged the function.
const std::string kTypes = R"(
%float = OpTypeFloat 32
%v3 = OpTypeVector %float 3
%quarter = OpConstant %float 0.25
)";
const std::string kLibrary = R"(OpCapability Shader
OpCapability Linkage
%set = OpExtInstImport "GLSL.std.450"
OpMemoryModel Logical GLSL450
OpDecorate %10 LinkageAttributes "shine" Export
)" + kTypes + R"(
%kind = OpTypeFunction %float %v3 %v3 %v3 %float
%10 = OpFunction %float None %kind
%11 = OpFunctionParameter %v3
%12 = OpFunctionParameter %v3
%13 = OpFunctionParameter %v3
%14 = OpFunctionParameter %float
%15 = OpLabel
%16 = OpFAdd %v3 %11 %12
%17 = OpExtInst %v3 %set Normalize %16
%18 = OpDot %float %13 %17
%19 = OpFMul %float %18 %quarter
%20 = OpFMul %float %19 %14
OpReturnValue %20
OpFunctionEnd
)";
const std::string kEntryPoint = R"(OpCapability Shader
%set = OpExtInstImport "GLSL.std.450"
OpMemoryModel Logical GLSL450
OpEntryPoint Fragment %10 "main" %11 %12 %13 %14
OpExecutionMode %10 OriginUpperLeft
OpDecorate %11 Location 3
OpDecorate %12 Location 1
OpDecorate %13 Location 2
OpDecorate %14 Location 0
)" + kTypes + R"(
%void = OpTypeVoid
%kind = OpTypeFunction %void
%in3 = OpTypePointer Input %v3
%in1 = OpTypePointer Input %float
%out = OpTypePointer Output %float
%11 = OpVariable %in3 Input
%12 = OpVariable %in3 Input
%13 = OpVariable %in1 Input
%14 = OpVariable %out Output
%10 = OpFunction %void None %kind
%15 = OpLabel
%21 = OpLoad %v3 %11
%22 = OpLoad %v3 %12
%23 = OpLoad %float %13
%16 = OpFAdd %v3 %21 %22
%17 = OpExtInst %v3 %set Normalize %16
%18 = OpCompositeExtract %float %17 2
%19 = OpFMul %float %18 %quarter
%20 = OpFMul %float %19 %23
OpStore %14 %20
OpReturn
OpFunctionEnd
)";

std::string assembled(const std::string& text) {
  Words words;
  EXPECT_TRUE(spvtools::SpirvTools(SPV_ENV_UNIVERSAL_1_6)
                  .Assemble(text, &words, SPV_TEXT_TO_BINARY_OPTION_PRESERVE_NUMERIC_IDS));
  return bytes_of(words);
}

Words words_of(const std::string& bytes) {
  Words words(bytes.size() / sizeof(Words::value_type));
  std::memcpy(words.data(), bytes.data(), bytes.size());
  return words;
}

// 1/4 of the default 0.5 times the cosine of the half vector, which is 1 for the mirror pair.
constexpr double kMirror = 0.125;

TEST(Module, OfALibraryIsReadByItsExportedName) {
  const std::string bytes = assembled(kLibrary);
  EXPECT_THAT(module_refusal(bytes), HasSubstr("float shine(vec3 %11, vec3 %12, vec3 %13, float %14)"));
  const auto shine = shader_of(bytes, {.file = "", .entry = "shine(L, V, N, k)"}, "own.spv");
  EXPECT_NEAR(value_at(shine, 50, 0, 50, 180), kMirror, 1e-15);
  EXPECT_NEAR(value_at(shine, 60, 0, 0, 0), kMirror * std::cos(30 * kPi / 180), 1e-15);
}

// SPIRV-Tools refuse languages of the source that are younger than themselves. The language has no effect.
TEST(Module, OfAYoungLanguageIsRead) {
  std::string text = kLibrary;
  text.insert(text.find("OpDecorate %10"), "OpSource GLSL 450\n");
  for (const std::uint32_t language : {2u, 10u, 11u, 99u}) {
    Words words = words_of(assembled(text));
    const auto source = std::ranges::find(words, 3u << 16 | std::uint32_t(spv::OpSource));
    ASSERT_NE(source, words.end());
    source[1] = language;
    const auto shine = shader_of(bytes_of(words), {.file = "", .entry = "shine(L, V, N, k)"}, "own.spv");
    EXPECT_NEAR(value_at(shine, 50, 0, 50, 180), kMirror, 1e-15) << language;
  }
}

TEST(Module, OfAnEntryPointIsReadByLocations) {
  const std::string bytes = assembled(kEntryPoint);
  const auto read = [&](const std::string& entry) {
    return shader_of(bytes, {.file = "", .entry = entry}, "own.spv");
  };
  const auto shine = read("main(3=L, 1=V, 2=k)");
  EXPECT_NEAR(value_at(shine, 60, 0, 0, 0), kMirror * std::cos(30 * kPi / 180), 1e-15);
  EXPECT_THAT(testing::PrintToString(shine->function().notes), HasSubstr("the optimiser's"));
  // By order: the inputs are sorted by location.
  EXPECT_EQ(value_at(read("main(V, k, L)"), 60, 0, 0, 0), value_at(shine, 60, 0, 0, 0));
  EXPECT_THAT(module_refusal(bytes), HasSubstr("--entry 'main(0=L, 1=V)'"));
  EXPECT_THAT(module_refusal(bytes, {.file = "", .entry = "main(3=L, 5=V)"}),
              HasSubstr("no input at this location"));
}

TEST(Module, MayHaveValuesOfSixteenBits) {
  const std::string text =
      "#extension GL_EXT_shader_explicit_arithmetic_types_float16 : require\n"
      "float brdf(vec3 L, vec3 V, vec3 N, float p) { return float(float16_t(p) * 0.1hf); }\n";
  const auto module = shader_of(bytes_of(compiled(text)), {}, "own.spv"), from_text = shader_of(text);
  EXPECT_TRUE(module->function().has_half_types);
  for (const auto& model : {module, from_text}) {
    const Material m = model->material(model);
    float value = 0;
    eval_batch(m.terms.front(), 0, one_pair(Vec3<float>{0, 0, 1}, Vec3<float>{0, 0, 1}), &value);
    EXPECT_EQ(value, 0.04998779296875f);  // half of 0.1 in half precision
    EXPECT_EQ(value_at(model, 0, 0, 0, 0), 0.05);
  }
}

TEST(Module, SaysThatRelaxedPrecisionMayBeComputedInHalfPrecision) {
  const auto notes = [](const std::string& text) {
    return testing::PrintToString(
        shader_of(assembled(text), {.file = "", .entry = "shine(L, V, N, k)"}, "own.spv")->function().notes);
  };
  const std::string export_line = "OpDecorate %10 LinkageAttributes";
  std::string relaxed = kLibrary;
  relaxed.insert(relaxed.find(export_line), "OpDecorate %19 RelaxedPrecision\n");
  EXPECT_THAT(notes(relaxed), HasSubstr("values may have 16 bits on a device"));
  EXPECT_THAT(notes(kLibrary), testing::Not(HasSubstr("16 bits")));
}

}  // namespace
}  // namespace brdf::shader
