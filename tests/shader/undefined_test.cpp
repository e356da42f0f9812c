// Values that the shading languages leave undefined are reported if a result depends on them, and only
// then.
#include <gtest/gtest.h>

#include "shader/undefined.h"
#include "tests/shader/texts.h"

namespace brdf::shader {
namespace {

std::string undefined_at(const std::string& body, double cos_i, double p = 0.5,
                         const std::string& before = "", const std::string& name = "test.glsl") {
  const auto model =
      shader_of("//: param p 0 1 0.5\n" + before +
                    "\nfloat brdf(vec3 L, vec3 V, vec3 N, float p) {\nfloat c = L.z;\n" + body + "\n}",
                {}, name);
  const Vec3<double> wi{std::sqrt(1 - cos_i * cos_i), 0, cos_i}, wo{0, 0.6, 0.8};
  const std::vector<double> values{p};
  const auto wide = undefined_value<double>(model->function(), values, wi, wo),
             narrow = undefined_value<float>(model->function(), values, wi, wo);
  EXPECT_EQ(wide.has_value(), narrow.has_value()) << body;
  return wide ? to_text(model->function(), *wide) : "";
}

struct UndefinedCase {
  const char *body, *sentence;
  double at, not_at;  // cosines of the incident direction
};

class UndefinedValues : public testing::TestWithParam<UndefinedCase> {};

TEST_P(UndefinedValues, AreFoundWithTheirLine) {
  const auto& [body, sentence, at, not_at] = GetParam();
  const std::string text = undefined_at(body, at);
  EXPECT_NE(text.find(sentence), std::string::npos) << text;
  EXPECT_EQ(text.find("line 5"), 0u) << text;
  EXPECT_EQ(undefined_at(body, not_at), "") << body;
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, UndefinedValues,
    testing::Values(UndefinedCase{"float s; if (c < 0.6) s = p; return 0.1 * s;", "read before it is written",
                                  0.7, 0.5},
                    UndefinedCase{"float a[2] = float[2](0.1, 0.3); return a[int(4.0 * c)];",
                                  "outside its array", 0.8, 0.3},
                    UndefinedCase{"float a[2] = float[2](0.1, 0.3); a[int(5.0 * c) - 1] = p; return a[0];",
                                  "outside its array", 0.1, 0.5},
                    UndefinedCase{"return 0.01 * float(9 / (int(3.0 * c) - 1));", "divided by 0", 0.5, 0.9},
                    UndefinedCase{"return 0.01 * float(9 % (int(3.0 * c) - 1));", "divided by 0", 0.5, 0.9},
                    UndefinedCase{"return 1e-9 * float(1 << (31 + int(2.0 * c)));", "shift", 0.7, 0.2},
                    UndefinedCase{"return p * pow(c - 0.5, 2.0);", "pow", 0.2, 0.8},
                    UndefinedCase{"return pow(max(c - 0.5, 0.0), p - 0.5);", "pow", 0.2, 0.8},
                    // The value is finite, but the condition that chooses it is not defined.
                    UndefinedCase{"return sqrt(c - 0.5) == 0.0 ? p : 0.1;", "sqrt", 0.2, 0.8},
                    UndefinedCase{"return inversesqrt(c - 0.5) < -1.0 ? p : 0.1;", "inversesqrt", 0.5, 0.8},
                    UndefinedCase{"return log(c - 0.5) > 9.0 ? p : 0.1;", "logarithm", 0.5, 0.8},
                    UndefinedCase{"return log2(c - 0.5) > 9.0 ? p : 0.1;", "logarithm", 0.2, 0.8},
                    UndefinedCase{"return acos(c + 0.5) > 9.0 ? p : 0.1;", "acos", 0.8, 0.2},
                    UndefinedCase{"return asin(c + 0.5) > 9.0 ? p : 0.1;", "asin", 0.8, 0.2},
                    UndefinedCase{"return 0.1 + 0.1 * cos(atan(max(c - 0.5, 0.0), V.x));", "atan", 0.2, 0.8},
                    UndefinedCase{"return smoothstep(0.4, 0.9 - c, p);", "smoothstep", 0.6, 0.2},
                    UndefinedCase{"return clamp(p, c, 0.5);", "clamp", 0.7, 0.3},
                    UndefinedCase{"return 0.1 * float(clamp(int(p), int(4.0 * c), 2));", "clamp", 0.9, 0.3},
                    UndefinedCase{"return max((c - 0.2) / (c - 0.2), 0.0);", "NaN", 0.2, 0.8},
                    UndefinedCase{"return 0.1 * float(int(4e9 * c) & 1);", "outside the range", 0.8, 0.2}));

TEST(Undefined, CountsOnlyWhereTheResultDependsOnIt) {
  // Both sides of a choice are computed, but only one is used.
  EXPECT_EQ(undefined_at("return c > 0.5 ? 0.1 : pow(c - 0.5, 2.0);", 0.8), "");
  EXPECT_NE(undefined_at("return c > 0.5 ? 0.1 : pow(c - 0.5, 2.0);", 0.2), "");
  EXPECT_EQ(undefined_at("float s; float t = s; return 0.1 * p;", 0.8), "");
  EXPECT_NE(undefined_at("float s; if (s > 0.5) return 0.1; return 0.2;", 0.8), "");
  EXPECT_EQ(undefined_at("float a[3]; a[1] = c; return a[1];", 0.8), "");
  EXPECT_NE(undefined_at("float a[3]; a[1] = c; return a[2];", 0.8), "");
  EXPECT_EQ(undefined_at("float s = 0.0; for (int k = 0; k < 3; ++k) s += c; return s;", 0.8), "");
}

TEST(Undefined, AMissingReturnIsOne) {
  const std::string half = "float half_of(float x) { if (x < 0.5) return x; }";
  EXPECT_NE(undefined_at("return half_of(c);", 0.8, 0.5, half).find("without a return"), std::string::npos);
  EXPECT_EQ(undefined_at("return half_of(c);", 0.3, 0.5, half), "");
}

TEST(Undefined, GlobalVariablesOfHlslBeginAtZero) {
  const std::string hlsl =
      "static float3 unused_value; float brdf(float3 L, float3 V, float3 N, float p) { return p * "
      "(0.1 + unused_value.x); }";
  const auto model = shader_of(hlsl, {}, "test.hlsl");
  EXPECT_FALSE(
      undefined_value<double>(model->function(), model->function().defaults(), {0, 0, 1}, {0, 0, 1}));
  EXPECT_NEAR(value_at(model, 10, 0, 20, 0), 0.05, 1e-12);
  const auto glsl = shader_of(
      "float unused_value; float brdf(vec3 L, vec3 V, vec3 N, float p) { return p * (0.1 + unused_value); }");
  EXPECT_TRUE(undefined_value<double>(glsl->function(), glsl->function().defaults(), {0, 0, 1}, {0, 0, 1}));
}

}  // namespace
}  // namespace brdf::shader
