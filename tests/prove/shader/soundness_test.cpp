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

// No property of these shaders may be proved; each is violated at some parameters.
void expect_unproved(const std::string& text, std::vector<Property> properties) {
  const auto proofs = all_proofs(text, std::move(properties));
  EXPECT_FALSE(proofs.empty()) << text;
  for (const Proof& p : proofs) EXPECT_NE(p.verdict, Verdict::proved) << text << "\n" << p.statement;
}

// Returns the proof of one property in one scalar.
Proof proof_of(const std::string& text, Property property, Precision precision) {
  for (Proof& p : all_proofs(text, {property}))
    if (p.claim.precision == precision) return std::move(p);
  return {};
}

// At the turn 0 the light has no coordinate along the bitangent, so that nothing underflows there.
TEST(SymmetryOfProofs, IsNotAssumedWhereUnderflowDependsOnTheTurn) {
  const std::string body =
      "float brdf(vec3 L, vec3 V, vec3 N, float k, float m, float r) { float x = L.x * (k * m * r), y = L.y "
      "* "
      "k * m * r; return 0.2 * (x * x + y * y + L.z * L.z) - 0.18; }";
  const std::string in_float =
      "//: param k 4.2e-45 4.2e-45 4.2e-45\n//: param m 7e28 7e28 7e28\n//: param r 3.3986e15 3.3986e15 "
      "3.3986e15\n";
  EXPECT_EQ(proof_of(in_float + body, Property::non_negative, Precision::float_type).verdict,
            Verdict::refuted);
  EXPECT_EQ(proof_of(in_float + body, Property::non_negative, Precision::double_type).verdict,
            Verdict::proved);
  const std::string in_double =
      "//: param k 1.48e-323 1.48e-323 1.48e-323\n//: param m 3e210 3e210 3e210\n//: param r 2.2489e112 "
      "2.2489e112 2.2489e112\n";
  EXPECT_EQ(proof_of(in_double + body, Property::non_negative, Precision::double_type).verdict,
            Verdict::refuted);
}

TEST(SymmetryOfProofs, IsNotAssumedWhereOverflowDependsOnTheTurn) {
  const std::string head = "float a = L.y * 3e22 * 4e21, b = L.y * 3e22 * 4e21; ";
  EXPECT_EQ(
      proof_of(with_body(head + "return 0.2 + 1e-36 * (a - b);"), Property::finite, Precision::float_type)
          .verdict,
      Verdict::refuted);
  EXPECT_EQ(proof_of(with_body(head + "return a < b + 1e36 ? 0.2 : -0.5;"), Property::non_negative,
                     Precision::float_type)
                .verdict,
            Verdict::refuted);
  for (const Proof& p : all_proofs(with_body("float a = L.y * 3e12 * 4e11, b = L.y * 3e12 * 4e11; return 0.2 "
                                             "+ 1e-26 * (a - b);"),
                                   kBoth))
    EXPECT_EQ(p.verdict, Verdict::proved) << "no number is infinite: " << p.statement;
}

TEST(UndefinedProofs, ComparisonsOfUndefinedNumbersAreUndefined) {
  for (const char* number : {"sqrt(L.z - 0.6)", "inversesqrt(L.z - 0.6)", "log(L.z - 0.6)", "log2(L.z - 0.6)",
                             "asin(L.z + 0.6)", "acos(L.z + 0.6)", "acos(L.z - 1.7)", "pow(L.z - 0.6, 1.5)"})
    for (const Proof& p : all_proofs(
             with_body("float s = " + std::string(number) + "; return s >= 0.2 ? 0.3 * p : 0.1;"), kBoth)) {
      EXPECT_EQ(p.verdict, Verdict::no_method) << number << ": " << p.statement;
      EXPECT_EQ(p.statement.find("undefined: line 2"), 0u) << number << ": " << p.statement;
    }
}

TEST(FaultsInProofs, AreSoughtInTheScalarOfTheClaim) {
  // In float the sum is 1 at every p.
  const std::string text =
      "//: param p 1 3 2\nfloat brdf(vec3 L, vec3 V, vec3 N, float p) { return (1.0 + 2e-10 * p) - 1.0 > 0.0 "
      "? "
      "-0.5 : 0.2; }";
  EXPECT_NE(proof_of(text, Property::non_negative, Precision::float_type).verdict, Verdict::refuted);
  EXPECT_EQ(proof_of(text, Property::non_negative, Precision::double_type).verdict, Verdict::refuted);
  // In float the sum rounds down to 1 and is subtracted entirely.
  const Proof p = proof_of(
      "//: param p 1 3 2\nfloat brdf(vec3 L, vec3 V, vec3 N, float p) { return (1.0 + 2e-10 * p) - 1.0 == "
      "0.0 ? "
      "-0.5 : 0.2; }",
      Property::non_negative, Precision::float_type);
  ASSERT_EQ(p.verdict, Verdict::refuted);
  EXPECT_EQ(p.witness->value, -0.5);
  EXPECT_NE(p.witness->command.find(" --float -"), std::string::npos) << p.witness->command;
}

TEST(FaultsInProofs, AreSeenInBoxesThatAreNegativeThroughout) {
  for (const Proof& p : all_proofs(
           with_body("return abs(p - 0.3) < 0.0003 && abs(V.z - 0.62) < 0.0004 && L.z > 0.2 ? -0.4 : 0.1;"),
           {Property::non_negative}, 10))
    EXPECT_EQ(p.verdict, Verdict::refuted) << p.statement;
}

TEST(LimitsOfProofs, AreNamed) {
  for (const Proof& p :
       all_proofs(with_body("float x = p * L.z; return x - x + 1e-30;"), {Property::non_negative}, 10)) {
    EXPECT_EQ(p.verdict, Verdict::bounded);
    EXPECT_NE(p.statement.find("the search ended at its limit of 3000 boxes"), std::string::npos)
        << p.statement;
  }
}

TEST(WholeParametersInProofs, AreWholeWhateverTheyAreBoundTo) {
  for (const Proof& p : all_proofs(
           "//: bool a 0\nfloat brdf(vec3 L, vec3 V, vec3 N, float a) { return 0.3 - 2.0 * a * (1.0 - a); }",
           {Property::non_negative}))
    EXPECT_EQ(p.verdict, Verdict::proved) << p.statement;
  for (const Proof& p :
       all_proofs("//: param n 0 3 1\nfloat brdf(vec3 L, vec3 V, vec3 N, int n) { float x = float(n) - 1.5; "
                  "return x * x - 0.2; }",
                  {Property::non_negative}))
    EXPECT_EQ(p.verdict, Verdict::proved) << p.statement;
  expect_unproved("//: bool a 1\nfloat brdf(vec3 L, vec3 V, vec3 N, float a) { return 0.3 - 0.4 * a; }",
                  {Property::non_negative});
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
