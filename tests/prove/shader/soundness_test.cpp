// Properties of a shader that must not be proved, and properties that must remain proved.
#include <gtest/gtest.h>

#include "prove/shader/self_test.h"
#include "prove/shader/shader_proof.h"
#include "tests/shader/texts.h"

namespace brdf::prove {
namespace {

std::vector<Proof> all_proofs(const std::string& text, std::vector<Property> properties, double seconds = 1) {
  const auto model = shader::shader_of(text);
  Options options;
  options.search = {3000, seconds};
  options.properties = std::move(properties);
  return prove(*model, model->material(model), " --shader x.glsl", options);
}

const std::vector<Property> kBoth{Property::finite, Property::non_negative};

std::string with_body(const std::string& body) {
  return "//: param p 0 1 0.5\nfloat brdf(vec3 L, vec3 V, vec3 N, float p) { " + body + " }";
}

TEST(SymmetryOfProofs, IsNotAssumedOfCodeThatReadsTheCoordinates) {
  for (const char* body :
       {"return V.y < -0.3 ? -0.5 : 0.2 * p;", "return L.x > 0.2 && L.x < 0.2001 ? -0.5 : 0.2 * p;"})
    for (const Proof& p : all_proofs(with_body(body), {Property::non_negative}))
      EXPECT_NE(p.verdict, Verdict::proved) << body;
  const auto energy =
      all_proofs(with_body("return (0.1 + 2.5 * L.y * L.y) / 3.14159265;"), {Property::energy});
  ASSERT_EQ(energy.size(), 1u);
  EXPECT_NE(energy[0].verdict, Verdict::proved);
}

TEST(SymmetryOfProofs, SoundIsotropicFunctionsStayProved) {
  const auto proofs =
      all_proofs(with_body("return p * (L.y * V.y + L.z * V.z + L.x * V.x + 1.01) / 6.5;"), kBoth);
  ASSERT_EQ(proofs.size(), 4u);
  for (const Proof& p : proofs) {
    EXPECT_EQ(p.verdict, Verdict::proved) << p.statement;
    EXPECT_EQ(p.cover.boxes, 1) << "the light was turned";
  }
}

TEST(UndefinedProofs, UndefinedValuesAreNeverProved) {
  for (const char* body :
       {"float s; if (L.z > 0.4) s = p; return s;",
        "float a[2] = float[2](0.1, 0.2); return a[int(2.5 * V.z)];",
        "return 0.1 * float(8 / int(4.0 * L.z));", "return 0.01 * float((1 << (29 + int(5.0 * L.z))) & 7);",
        "return p * pow(V.z - 1.5, 2.0);", "return 0.2 * smoothstep(p, p, L.z);",
        "return clamp(L.z, 0.6, p);", "return max(sqrt(L.z - 0.5), 0.0);"}) {
    for (const Proof& p : all_proofs(with_body(body), kBoth)) {
      EXPECT_EQ(p.verdict, Verdict::no_method) << body << ": " << p.statement;
      EXPECT_EQ(p.statement.find("undefined: line 2"), 0u) << body << ": " << p.statement;
    }
    for (const Proof& p : all_proofs(with_body(body), {Property::energy}))
      EXPECT_NE(p.verdict, Verdict::proved) << body;
  }
}

TEST(UndefinedProofs, ArraysThatAreReadWithinTheirRangeStayProved) {
  for (const Proof& p :
       all_proofs(with_body("float a[3] = float[3](0.1, 0.2, 0.3); return p * a[clamp(int(3.0 * L.z), 0, "
                            "2)] + 0.01 * float(7 / (1 + int(2.0 * V.z)));"),
                  kBoth))
    EXPECT_EQ(p.verdict, Verdict::proved) << p.statement;
}

TEST(LengthsInProofs, AreNotTrustedWhereTheirSquaresAreSubnormal) {
  const std::string text =
      "//: param p 7.85e-23 7.95e-23 7.9e-23\nfloat brdf(vec3 L, vec3 V, vec3 N, float p) { return 1.02 - p "
      "/ sqrt(p * p); }";
  const auto proofs = all_proofs(text, {Property::non_negative});
  ASSERT_EQ(proofs.size(), 2u);
  EXPECT_NE(proofs[0].verdict, Verdict::proved) << "float";
  EXPECT_EQ(proofs[1].verdict, Verdict::proved) << "double: the squares are normal numbers there";
}

TEST(SentencesOfProofs, NameTheLeastCosine) {
  for (const Proof& p : all_proofs(with_body("return max(L.z, V.z) * min(L.z, V.z) < 1e-7 ? -0.2 : 0.3 * p;"),
                                   {Property::non_negative})) {
    EXPECT_EQ(p.verdict, Verdict::proved);
    EXPECT_NE(p.statement.find("for cosines from 0.001"), std::string::npos) << p.statement;
    EXPECT_NE(p.statement.find("below that f is negative"), std::string::npos) << p.statement;
  }
}

// No property of these shaders may be proved; each is violated at some parameters.
void expect_unproved(const std::string& text, std::vector<Property> properties) {
  const auto proofs = all_proofs(text, std::move(properties));
  EXPECT_FALSE(proofs.empty()) << text;
  for (const Proof& p : proofs) EXPECT_NE(p.verdict, Verdict::proved) << text << "\n" << p.statement;
}

TEST(InfiniteConstants, AreNotProvedToVanish) {
  for (const char* body :
       {"float big = 1.0 / 0.0; return 0.2 * p + 0.0 * big;", "float big = 3e39; return 0.0 * big + 0.3 * p;",
        "float big = 3.4e38 * 12.0; return p * 0.1 + (p - p) * big;"})
    expect_unproved(with_body(body), {Property::finite, Property::non_negative, Property::energy});
  expect_unproved(with_body("if (isinf(2.0 / 0.0)) return -0.7; return 0.2 * p;"), {Property::non_negative});
}

TEST(ColoursInProofs, AreNotGreyIfChannelsMix) {
  const std::string head =
      "//: color c 0.5 0.5 0.5\n//: param p 0 1 0.5\nvec3 brdf(vec3 L, vec3 V, vec3 N, vec3 c, float p) { ";
  for (const char* body : {"return vec3(0.1 * c.r, 0.04 + 0.1 * c.g - 0.09 * c.r, 0.1 * c.b);",
                           "return p > 0.96 ? 0.03 + 0.1 * c - 0.08 * c.gbr : 0.1 * c;",
                           "vec3 f = 0.1 * c; if (p > 0.97) f.b -= 0.09 * c.g; return f;"})
    expect_unproved(head + body + " }", {Property::non_negative});
  expect_unproved(head + "return vec3(0.2 * c.r, 0.25 * c.g + 0.28 * (1.0 - c.r), 0.2 * c.b); }",
                  {Property::energy});
  expect_unproved(head + "vec3 f = vec3(0.2 * p); if (p > 0.95) f.g = -0.3; return f; }",
                  {Property::non_negative});
}

TEST(ColoursInProofs, OfSeparateChannelsStayProved) {
  for (const char* body :
       {"return c * (0.2 + 0.1 * p);",
        "vec3 f; for (int k = 0; k < 3; ++k) f[k] = c[k] > 0.04 ? c[k] : 0.5 * c[k]; return 0.2 * f;"})
    for (const Proof& p : all_proofs("//: color c 0.5 0.5 0.5\n//: param p 0 1 0.5\nvec3 brdf(vec3 L, vec3 "
                                     "V, vec3 N, vec3 c, float p) { " +
                                         std::string(body) + " }",
                                     kBoth))
      EXPECT_EQ(p.verdict, Verdict::proved) << body << ": " << p.statement;
}

TEST(WeightsInProofs, AreLinearOnlyIfTheProgramShowsIt) {
  // A weight that is cut off, or that counts more between two values. No light is gained at any weight.
  for (const char* body :
       {"min(kd, 0.8)", "clamp(kd, 0.0, 0.7)", "(kd > 3.1 && kd < 3.2 ? 0.3 * kd : 0.2 * kd)"}) {
    const std::string text = "//: param kd 0 4 0.5\nfloat brdf(vec3 L, vec3 V, vec3 N, float kd) { return " +
                             std::string(body) + " / 3.14159265; }";
    EXPECT_TRUE(shader::shader_of(text)->info().lobes.empty()) << body;
    for (const Proof& p : all_proofs(text, {Property::energy}))
      EXPECT_NE(p.verdict, Verdict::refuted) << body << ": " << p.statement;
  }
  EXPECT_EQ(shader::shader_of("//: param kd 0 1 0.5\nfloat brdf(vec3 L, vec3 V, vec3 N, float kd) { float f "
                              "= 0.0; if (kd > 0.0) f += clamp(kd, 0.0, 1.0) / 3.14159265; return f; }")
                ->info()
                .lobes.size(),
            1u);
}

TEST(InputsOfProofs, AreAllNumbersThatTheFunctionReads) {
  expect_unproved(
      "//: param m 0 1 0.5\nuniform vec4 m;\nfloat brdf(vec3 L, vec3 V, vec3 N) { return 0.3 * m.x * m.w - "
      "0.1 * (1.0 - m.w); }",
      {Property::non_negative});
  // A truth value of another function of the same name makes no truth value of a number.
  EXPECT_NE(shader::refusal(
                "uniform uint mode;\nfloat other(float x) { bool mode = x > 0.3; return mode ? 1.0 : 0.4; "
                "}\nfloat brdf(vec3 L, vec3 V, vec3 N) { return mode == 3u ? -0.2 : 0.1 * other(L.z); }")
                .find("mode of float brdf"),
            std::string::npos);
}

TEST(NamesInProofs, OfTheLibrarysKernelsMayBeTheUsers) {
  expect_unproved(
      "//: param p 0.1 1 0.5\nfloat brdf_exp(float x) { return 1.0 - 2.0 * x; }\nfloat brdf(vec3 L, vec3 V, "
      "vec3 N, float p) { return 0.1 * brdf_exp(p); }",
      {Property::non_negative});
}

TEST(UndefinedProofs, RemaindersOfNumbersBelowZeroAndHalvesAreOpen) {
  const std::string head = "//: param n -6 6 0\nfloat brdf(vec3 L, vec3 V, vec3 N, int n) { ";
  expect_unproved(head + "return (n % 5) <= 4 ? 0.2 : 0.1; }", kBoth);
  expect_unproved(with_body("return round(2.5 + 0.0 * p) > 2.0 ? -0.1 : 0.1;"), {Property::non_negative});
  for (const Proof& p : all_proofs(head + "return ((n + 6) % 5) <= 4 ? 0.2 : 0.1; }", kBoth))
    EXPECT_EQ(p.verdict, Verdict::proved) << p.statement;
}

TEST(SelfTestOfProofs, FindsNoFalseVerdict) {
  SelfTestOptions options;
  options.planted = 25, options.sound = 10, options.samples = 25'000, options.seconds = 0.2, options.seed = 5;
  const SelfTest t = self_test(options);
  EXPECT_EQ(t.planted, 25);
  EXPECT_EQ(t.sound, 10);
  EXPECT_GE(t.sound_proved, 8);
  EXPECT_GE(t.samples_float, 25'000);
  EXPECT_TRUE(t.good()) << (t.faults.empty() ? "" : t.faults.front());
}

}  // namespace
}  // namespace brdf::prove
