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
