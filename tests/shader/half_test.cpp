// Values of 16 bits: rounding to half precision, and which operations of a shader are rounded.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>

#include "shader/blame.h"
#include "shader/half_precision.h"
#include "shader/program/half.h"
#include "tests/shader/texts.h"

namespace brdf::shader {
namespace {

using testing::HasSubstr;
using testing::Not;

const Vec3<double> kUp{0, 0, 1}, kSlanted{0.6, 0, 0.8};

double half_at(const std::shared_ptr<const ShaderReflectance>& model, const std::vector<double>& values,
               const Vec3<double>& wi = kSlanted, std::size_t component = 0) {
  return in_half(model->function(), values, wi, kUp, component);
}

float float_at(const std::shared_ptr<const ShaderReflectance>& model, const Vec3<double>& wi = kSlanted) {
  const Material m = model->material(model);
  const Vec3<float> i{float(wi.x), float(wi.y), float(wi.z)}, o{0, 0, 1};
  float out = 0;
  eval_batch(m.terms.front(), 0, one_pair(i, o), &out);
  return out;
}

double double_at(const std::shared_ptr<const ShaderReflectance>& model, const Vec3<double>& wi = kSlanted) {
  const Material m = model->material(model);
  double out = 0;
  eval_batch(m.terms.front(), 0, one_pair(wi, kUp), &out);
  return out;
}

std::string all_notes(const std::shared_ptr<const ShaderReflectance>& model) {
  return testing::PrintToString(model->function().notes);
}

TEST(Half, RoundsToTheNearestNumberAndTiesToEven) {
  float before = -std::numeric_limits<float>::infinity();
  for (std::uint32_t bits = 0; bits < 0x7c00; ++bits) {
    const float x = half_of_bits(std::uint16_t(bits)), next = half_of_bits(std::uint16_t(bits + 1));
    EXPECT_GT(x, before);
    before = x;
    EXPECT_EQ(rounded_to_half(x), x);
    EXPECT_EQ(std::bit_cast<std::uint32_t>(rounded_to_half(-x)), std::bit_cast<std::uint32_t>(-x));
    const float middle = bits < 0x7bff ? (x + next) / 2 : 65520;
    const float even = bits % 2 == 0 ? x : next;
    EXPECT_EQ(rounded_to_half(middle), even) << x;
    EXPECT_EQ(rounded_to_half(std::nextafter(middle, 0.0f)), x);
    EXPECT_EQ(rounded_to_half(std::nextafter(middle, 1e6f)), next);
    EXPECT_EQ(rounded_to_half(-std::nextafter(middle, 1e6f)), -next);
  }
  EXPECT_EQ(half_of_bits(1), 0x1p-24f);
  EXPECT_EQ(half_of_bits(0x3c01), 1 + 0x1p-10f);
  EXPECT_EQ(half_of_bits(0x7bff), kLargestHalf);
  EXPECT_EQ(half_of_bits(0xfc00), -std::numeric_limits<float>::infinity());
  EXPECT_EQ(rounded_to_half(1e30f), std::numeric_limits<float>::infinity());
  EXPECT_EQ(rounded_to_half(-std::numeric_limits<float>::infinity()),
            -std::numeric_limits<float>::infinity());
  EXPECT_TRUE(std::isnan(rounded_to_half(std::numeric_limits<float>::quiet_NaN())));
  EXPECT_TRUE(std::isnan(half_of_bits(0x7e00)));
}

// 2049 p is 2048 p or 2050 p in half precision: of the operations of `mediump` alone.
TEST(Half, RoundsEachOperationThatTheFileAllows) {
  const auto narrow = shader_of(
      "//: param p 0 1 1\n"
      "float brdf(vec3 L, vec3 V, vec3 N, float p) {\n"
      "  mediump float big = 2048.0 * p;\n"
      "  big = big + 1.0;\n"
      "  return (big - 2048.0 * p) * 0.125;\n}\n");
  ASSERT_TRUE(narrow->function().in_half);
  EXPECT_FALSE(narrow->function().has_half_types);
  EXPECT_EQ(half_at(narrow, {1}), 0);
  EXPECT_EQ(float_at(narrow), 0.125f);
  EXPECT_EQ(double_at(narrow), 0.125);
  EXPECT_THAT(all_notes(narrow), HasSubstr("values may have 16 bits on a device (the first in line 4)"));
  // A precision that applies to the whole file, and a value that is excepted.
  const std::string text =
      "precision mediump float;\n//: param p 0 1 1\n"
      "float brdf(vec3 L, vec3 V, vec3 N, KIND float p) {\n"
      "  KIND float big = 2048.0 * p + 1.0;\n  return (big - 2048.0 * p) * 0.125;\n}\n";
  const auto with = [&](const std::string& kind) {
    std::string out = text;
    for (std::size_t at; (at = out.find("KIND")) != out.npos;) out.replace(at, 4, kind);
    return shader_of(out);
  };
  EXPECT_EQ(half_at(with("mediump"), {1}), 0);
  EXPECT_EQ(half_at(with(""), {1}), 0);
  EXPECT_EQ(half_at(with("lowp"), {1}), 0);
  EXPECT_EQ(half_at(with("highp"), {1}), 0.125);
}

TEST(Half, IsKnownInHlsl) {
  for (const std::string type : {"half", "min16float"}) {
    const auto model =
        shader_of("//: param p 0 1 1\nfloat brdf(float3 L, float3 V, float3 N, float p) {\n  " + type +
                      " big = 2048.0 * p + 1.0;\n  return (big - 2048.0 * p) * 0.125;\n}\n",
                  {}, "a.hlsl");
    ASSERT_TRUE(model->function().in_half) << type;
    EXPECT_EQ(half_at(model, {1}), 0) << type;
    EXPECT_EQ(double_at(model), 0.125) << type;
  }
  // A file that defines half itself means another type.
  const auto own = shader_of(
      "#define half float\n//: param p 0 1 1\nfloat brdf(float3 L, float3 V, float3 N, half p) {\n"
      "  half big = 2048.0 * p + 1.0;\n  return (big - 2048.0 * p) * 0.125;\n}\n",
      {}, "a.hlsl");
  EXPECT_FALSE(own->function().in_half);
  EXPECT_EQ(own->function().half_unknown, "");
}

// Types of exactly 16 bits are rounded in float, in memory, too; constants are constants of half precision.
TEST(Half, OfTypesWithSixteenBitsIsPartOfFloat) {
  const std::string text =
      "#extension GL_EXT_shader_explicit_arithmetic_types_float16 : require\n//: param p 0 1 1\n"
      "float brdf(vec3 L, vec3 V, vec3 N, float p) {\n"
      "  float16_t x = float16_t(p), tenth = 0.1hf;\n"
      "  float16_t big = 2048.0hf * x + 1.0hf;\n"
      "  return float(big - 2048.0hf * x) + float(x * tenth);\n}\n";
  const auto model = shader_of(text);
  ASSERT_TRUE(model->function().in_half);
  EXPECT_TRUE(model->function().has_half_types);
  EXPECT_EQ(float_at(model), 0.0999755859375f);
  EXPECT_EQ(half_at(model, {1}), 0.0999755859375);
  EXPECT_EQ(double_at(model), 1.1);
  EXPECT_THAT(all_notes(model), HasSubstr("values have 16 bits (the first in line 4)"));
  // An argument is rounded before it is read.
  const auto argument = shader_of(
      "#extension GL_EXT_shader_explicit_arithmetic_types_float16 : require\n//: param p 0 1 0.1\n"
      "float brdf(vec3 L, vec3 V, vec3 N, float16_t p) { return float(p); }\n");
  EXPECT_EQ(float_at(argument), 0.0999755859375f);
  EXPECT_EQ(double_at(argument), 0.1);
}

TEST(Half, IsNotClaimedOfTextsWithoutIt) {
  const auto plain = shader_of(kGgx);
  EXPECT_FALSE(plain->function().in_half);
  EXPECT_THAT(all_notes(plain), Not(HasSubstr("16 bits")));
  // An unused value.
  const auto unused = shader_of(
      "float brdf(vec3 L, vec3 V, vec3 N, float p) {\n  mediump float d = L.z * p;\n"
      "  return p * 0.1;\n}\n");
  EXPECT_FALSE(unused->function().in_half);
  // The usual guard for browsers is not compiled; a note tells so.
  const std::string guarded =
      "#ifdef GL_ES\nprecision mediump float;\n#endif\nfloat brdf(vec3 L, vec3 V, vec3 N, float p) { return "
      "p * "
      "L.z; }\n";
  EXPECT_FALSE(shader_of(guarded)->function().in_half);
  EXPECT_THAT(all_notes(shader_of(guarded)), HasSubstr("mediump is not compiled"));
  EXPECT_TRUE(shader_of(guarded, {.file = "", .defines = {"GL_ES"}})->function().in_half);
}

// A uniform without a block, which the rules that keep mediump put into one.
TEST(Half, KeepsUniformsAndTheirInitialValues) {
  const auto model = shader_of(
      "uniform mediump float gloss = 0.25;\nuniform vec3 tint;\n//: color tint 0.5 0.25 0.125\n"
      "//: param gloss 0 1 0.25\n"
      "vec3 brdf(vec3 L, vec3 V, vec3 N) { mediump float g = gloss; return tint * g * L.z; }\n");
  ASSERT_TRUE(model->function().in_half);
  EXPECT_DOUBLE_EQ(double_at(model), 0.5 * 0.25 * 0.8);
}

// The operation that loses the value is named, with the reason.
TEST(Half, ALossIsExplained) {
  const auto why = [](const std::string& body) {
    const auto model =
        shader_of("//: param p 0 1 0.001\nmediump float brdf(vec3 L, vec3 V, vec3 N, mediump float p) {\n" +
                  body + "\n}\n");
    const std::vector<double> values{0.001};
    return to_text(blame<double>(*model->function().in_half, Fault::loses_digits, values, kSlanted, kUp, 0));
  };
  EXPECT_THAT(why("mediump float a = p * p;\nreturn 1e4 * (a * a);"),
              testing::AllOf(HasSubstr("line 4"), HasSubstr("an underflow")));
  EXPECT_THAT(why("mediump float a = 100.0 / p;\nreturn 1e-6 * a;"),
              testing::AllOf(HasSubstr("line 3"), HasSubstr("an overflow: the largest number is 65504")));
  // A division by a number that was rounded to 0.
  EXPECT_THAT(why("mediump float a = p * p * p;\nreturn 0.01 * (1.0 / a);"),
              testing::AllOf(HasSubstr("line 3"), HasSubstr("in half precision 0 (an underflow")));
}

}  // namespace
}  // namespace brdf::shader
