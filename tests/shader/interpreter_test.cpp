// Programs with divergent branches, loops and arrays, and the source line that is reported for a fault.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "brdf/random.h"
#include "io/files/error.h"
#include "shader/blame.h"
#include "tests/shader/texts.h"

namespace brdf::shader {
namespace {

using testing::HasSubstr;

// Collatz steps of a number computed from the directions, so that every lane follows its own path.
constexpr const char* kParting = R"(
float brdf(vec3 L, vec3 V, vec3 N) {
  int n = int(100.0 * abs(L.x)) + 1;
  float table[4] = float[4](0.5, 1.5, 2.5, 3.5);
  float sum = 0.0;
  for (int k = 0; k < 200; ++k) {
    if (n == 1) break;
    if (n % 2 == 0) { n = n / 2; sum += table[n & 3]; continue; }
    n = 3 * n + 1;
    table[n & 3] += 0.25;
  }
  switch (n + int(10.0 * V.z)) {
    case 5: sum += 100.0; break;
    case 8: sum += 200.0;
    case 9: sum += 300.0; break;
    default: sum += L.y > 0.0 && V.y > 0.0 ? 7.0 : 11.0;
  }
  return sum;
}
)";

double parting(const Vec3<double>& l, const Vec3<double>& v) {
  int n = int(100.0 * std::abs(l.x)) + 1;
  double table[4] = {0.5, 1.5, 2.5, 3.5}, sum = 0;
  for (int k = 0; k < 200 && n != 1; ++k) {
    if (n % 2 == 0) {
      n /= 2;
      sum += table[n & 3];
    } else {
      n = 3 * n + 1;
      table[n & 3] += 0.25;
    }
  }
  const int which = n + int(10.0 * v.z);
  if (which == 5) return sum + 100;
  if (which == 8) return sum + 500;
  if (which == 9) return sum + 300;
  return sum + (l.y > 0 && v.y > 0 ? 7 : 11);
}

// An input keeps its value, wherever the program reads it first.
TEST(Interpreter, AnInputThatABranchReadsFirstIsKnownAfterIt) {
  const std::string body = "{ float a = 0.0; if (L.z < 0.5) a = k; return 0.125 * a + k; }";
  const auto own = shader_of("uniform float k;\nfloat brdf(vec3 L, vec3 V, vec3 N) " + body,
                             {.file = "", .parameters = {}});
  const auto block = shader_of("cbuffer B { float k; };\nfloat brdf(float3 L, float3 V, float3 N) " + body,
                               {.file = "", .parameters = {"k=0:1:0.5"}}, "a.hlsl");
  const auto narrow = shader_of("uniform mediump float k;\nfloat brdf(vec3 L, vec3 V, vec3 N) " + body);
  for (const auto& model : {own, block, narrow}) {
    EXPECT_EQ(value_at(model, 0, 0, 0, 0), 0.5);
    EXPECT_EQ(value_at(model, 80, 0, 0, 0), 0.5625);
  }
  // A global variable has its initial value once, before the loop that changes it.
  const auto counted = shader_of(
      "const float tenths[2] = float[2](0.25, 0.5);\nfloat total = 0.125;\n"
      "float brdf(vec3 L, vec3 V, vec3 N) {\n  for (int k = 0; k < 2; ++k) if (L.z > 0.5) total += "
      "tenths[k];\n"
      "  return total;\n}\n");
  EXPECT_EQ(value_at(counted, 0, 0, 0, 0), 0.875);
  EXPECT_EQ(value_at(counted, 80, 0, 0, 0), 0.125);
}

TEST(Interpreter, LanesThatPartMeetAgain) {
  const auto shader = shader_of(kParting);
  Random random(3);
  constexpr std::size_t kCount = 777;
  DirectionArrays<double> d(kCount);
  for (std::size_t k = 0; k < kCount; ++k)
    d.set(k, direction(degrees(random.uniform(0, 89)), degrees(random.uniform(0, 360))),
          direction(degrees(random.uniform(0, 89)), degrees(random.uniform(0, 360))));
  std::vector<double> out(kCount);
  shader->eval(ParameterValues<double>{}, d.view(), out.data());
  for (std::size_t k = 0; k < kCount; ++k) ASSERT_EQ(out[k], parting(d.view().wi(k), d.view().wo(k))) << k;
}

TEST(Interpreter, AnEndlessLoopEndsWithItsLine) {
  try {
    shader_of(
        "//: param k 0 1 1\nfloat brdf(vec3 L, vec3 V, float k) {\n  float s = k;\n  while (s >= 0.0)\n    s "
        "+= 1.0;\n  return s;\n}");
    FAIL();
  } catch (const InputError& e) {
    EXPECT_THAT(e.what(), HasSubstr("this loop may not end"));
    EXPECT_THAT(e.what(), testing::ContainsRegex(R"(for light \(.*\), viewer \(.*\), k=)"));
    EXPECT_TRUE(std::string(e.what()).starts_with("test.glsl:4") ||
                std::string(e.what()).starts_with("test.glsl:5"))
        << e.what();
  }
}

TEST(Interpreter, FloatRoundsEveryOperation) {
  const auto shader = shader_of(
      "float brdf(vec3 L, vec3 V, vec3 N, float a, float b) { return exp(a) * log(b) + pow(b, a) / sqrt(a) - "
      "exp2(b); }",
      {.file = "", .parameters = {"a=0.1:8:1", "b=0.1:8:1"}});
  Random random(4);
  const Vec3<float> up{0, 0, 1};
  for (int k = 0; k < 2000; ++k) {
    const float a = float(random.uniform(0.1, 8)), b = float(random.uniform(0.1, 8));
    const auto f = [](double x) { return float(x); };
    const float expected = f(std::exp(double(a))) * f(std::log(double(b))) +
                           f(std::pow(double(b), double(a))) / std::sqrt(a) - f(std::exp2(double(b)));
    const std::vector<float> shape{a, b};
    float value;
    shader->eval(ParameterValues<float>{{}, {}, shape}, one_pair(up, up), &value);
    ASSERT_EQ(value, expected) << a << ' ' << b;
  }
}

TEST(Interpreter, WholePowersAreRoundedOnce) {
  const auto shader = shader_of(
      "float brdf(vec3 L, vec3 V, vec3 N, float a) { return pow(a, 5.0) + pow(a, 16.0) * pow(1.0 - a, 2.0); "
      "}",
      {.file = "", .parameters = {"a=-1:40:1"}});
  Random random(5);
  const Vec3<float> up{0, 0, 1};
  const auto value = [&](float a) {
    const std::vector<float> shape{a};
    float f;
    shader->eval(ParameterValues<float>{{}, {}, shape}, one_pair(up, up), &f);
    return f;
  };
  for (int k = 0; k < 2000; ++k) {
    const float a = float(random.uniform(0, 1));
    const auto f = [](double x) { return float(x); };
    const float expected =
        f(std::pow(double(a), 5)) + f(std::pow(double(a), 16)) * f(std::pow(double(1 - a), 2));
    ASSERT_EQ(value(a), expected) << a;
  }
  EXPECT_TRUE(std::isnan(value(-0.5f)));
  EXPECT_TRUE(std::isnan(value(2)));  // the base 1 - a is negative
  EXPECT_EQ(value(0), 0);
}

TEST(Interpreter, ConstantsAreWhatTheSourceSays) {
  const auto shader = shader_of("float brdf(vec3 L, vec3 V) { return 0.1 + 0.0 * L.x; }");
  EXPECT_EQ(value_at(shader, 10, 0, 20, 0), 0.1);
}

TEST(Blame, NoNumberAtNormalIncidence) {
  const auto shader = shader_of(
      "float brdf(vec3 L, vec3 V, vec3 N) {\n  vec3 t = L - N * dot(N, L);\n  vec3 u = normalize(t);\n  "
      "return 0.3 + 0.1 * dot(u, V);\n}");
  const Vec3<double> up{0, 0, 1}, aside = direction(degrees(30), {});
  const Blame b = blame<double>(shader->function(), Fault::not_finite, {}, up, aside, 0);
  EXPECT_EQ(b.line, 3u);
  EXPECT_EQ(b.expression, "vec3 u = normalize(t);");
  EXPECT_THAT(b.operation, HasSubstr("0 / 0 = "));
  EXPECT_TRUE(blame<double>(shader->function(), Fault::not_finite, {}, aside, up, 0).operation.empty());
}

TEST(Blame, TheSubtractionThatGoesBelowZero) {
  const auto shader = shader_of(
      "float brdf(vec3 L, vec3 V, vec3 N) {\n  float c = dot(N, L);\n  float d = 0.5 * c - 0.5;\n  return "
      "2.0 * d * c;\n}");
  const Blame b =
      blame<double>(shader->function(), Fault::negative, {}, direction(degrees(60), {}), {0, 0, 1}, 0);
  EXPECT_EQ(b.line, 3u);
  EXPECT_THAT(b.operation, HasSubstr("0.25 - 0.5 = -0.25"));
}

TEST(Blame, DivisionByZeroInFloatOnly) {
  const auto shader = shader_of(
      "float brdf(vec3 L, vec3 V, vec3 N) {\n  float x = 1.0 + 1e-9 * dot(N, L);\n  float d = x - 1.0;\n  "
      "return 1e-9 / d;\n}");
  const Vec3<double> w = direction(degrees(30), {});
  const Blame b = blame<float>(shader->function(), Fault::loses_digits, {}, w, w, 0);
  EXPECT_EQ(b.line, 4u);
  EXPECT_THAT(b.operation, HasSubstr("/ 0 = inf"));
  EXPECT_TRUE(blame<double>(shader->function(), Fault::not_finite, {}, w, w, 0).operation.empty());
}

TEST(Blame, TheComparisonThatIsPassed) {
  const auto shader = shader_of(
      "float brdf(vec3 L, vec3 V, vec3 N) {\n  float c = dot(N, L);\n  if (c > 0.5)\n    return 0.1;\n  "
      "return 0.2;\n}");
  const auto at = [](double theta) { return direction(degrees(theta), {}); };
  const Blame b = blame_jump(shader->function(), {}, {at(59.999), {0, 0, 1}}, {at(60.001), {0, 0, 1}}, 0);
  EXPECT_EQ(b.line, 3u);
  EXPECT_THAT(b.operation, HasSubstr("passes"));
}

TEST(Blame, TheOperationThatLosesDigits) {
  const auto shader = shader_of(
      "float brdf(vec3 L, vec3 V, vec3 N) {\n  float c = dot(N, L);\n  float s2 = 1.0 - c * c;\n  float r = "
      "3.0 * s2;\n  return r + 1e-20;\n}");
  const Vec3<double> w = direction(degrees(0.02), {});
  const Blame b = blame<float>(shader->function(), Fault::loses_digits, {}, w, w, 0);
  EXPECT_EQ(b.line, 3u);
  EXPECT_THAT(b.operation, HasSubstr(", in double "));
}

}  // namespace
}  // namespace brdf::shader
