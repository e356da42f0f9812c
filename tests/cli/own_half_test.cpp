// Tests the verdicts about shaders with types of 16 bits.
#ifdef BRDF_HAS_SHADER
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/cli/run_brdf.h"

namespace brdf {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

struct FloatFinding {
  std::string verdict, statement;
};

FloatFinding float_finding(const std::string& name, const std::string& text) {
  io::TemporaryFolder folder;
  std::ofstream(folder.path() / name) << text;
  const Outcome o = run_brdf("validate --json --shader " + name, folder.path());
  const nlohmann::json all = nlohmann::json::parse(o.out, nullptr, false);
  EXPECT_FALSE(all.is_discarded()) << o.err;
  for (const auto& f : all["findings"])
    if (f["check"] == "float") return {f["verdict"], f["statement"]};
  return {};
}

// A lobe whose squared width half precision cannot add to 1.
const std::string kNarrowLobe = R"(//: param width 0.1 1 0.3
TYPE brdf(TYPE3 L, TYPE3 V, TYPE3 N, TYPE width) {
  TYPE a2 = width * width * width * width;
  TYPE h = saturate(dot(N, normalize(L + V))), d = h * h * (a2 - 1.0) + 1.0;
  return a2 / (12.5663706 * d * d);
}
)";

std::string narrow_lobe(const std::string& type) {
  std::string out = kNarrowLobe;
  for (std::size_t at; (at = out.find("TYPE")) != out.npos;) out.replace(at, 4, type);
  return out;
}

TEST(OwnHalf, ALobeThatHalfPrecisionCannotHoldFails) {
  for (const std::string type : {"half", "min16float"}) {
    const FloatFinding f = float_finding("lobe.hlsl", narrow_lobe(type));
    EXPECT_EQ(f.verdict, "fail");
    EXPECT_THAT(
        f.statement,
        AllOf(HasSubstr("not finite in half precision"), HasSubstr("line 4"),
              HasSubstr("-1 + 1 = 0 with operands in half precision, in double 0.0001; then line 5: "),
              HasSubstr("/ 0 = inf")))
        << type;
  }
  // In 32 bits the same lobe passes, and nothing is said of half precision.
  const FloatFinding wide = float_finding("lobe.hlsl", narrow_lobe("float"));
  EXPECT_EQ(wide.verdict, "pass") << wide.statement;
  EXPECT_THAT(wide.statement, Not(HasSubstr("half")));
}

TEST(OwnHalf, AShaderThatIsAccurateInHalfPrecisionPasses) {
  const FloatFinding f =
      float_finding("soft.glsl",
                    "//: param p 0.1 1 0.5\nmediump float brdf(mediump vec3 L, mediump vec3 V, mediump vec3 "
                    "N, mediump float p) {\n"
                    "  mediump float c = dot(N, L) * dot(N, V);\n  return p * (0.2 + 0.1 * c);\n}\n");
  EXPECT_EQ(f.verdict, "pass");
  EXPECT_THAT(f.statement, AllOf(StartsWith("float and double of the same code agree"),
                                 HasSubstr("half precision and double of the same code agree")));
  // With highp the sum is exact enough; with mediump it is not.
  const std::string cancelling =
      "//: param p 0.1 1 0.5\nfloat brdf(vec3 L, vec3 V, vec3 N, float p) {\n"
      "  KIND float big = 1000.0 + p;\n  return (big - 1000.0) * 0.3;\n}\n";
  const auto with = [&](const std::string& kind) {
    std::string text = cancelling;
    return float_finding("sum.glsl", text.replace(text.find("KIND"), 4, kind));
  };
  EXPECT_EQ(with("highp").verdict, "pass");
  const FloatFinding lost = with("mediump");
  EXPECT_EQ(lost.verdict, "fail");
  EXPECT_THAT(lost.statement, AllOf(HasSubstr("float and double of the same code agree"), HasSubstr("line 4"),
                                    HasSubstr("with operands in half precision")));
}

TEST(OwnHalf, TypesOfSixteenBitsAreJudgedInFloat) {
  const std::string text =
      "#extension GL_EXT_shader_explicit_arithmetic_types_float16 : require\n//: param p 0.1 1 0.5\n"
      "float brdf(vec3 L, vec3 V, vec3 N, float p) {\n  float16_t x = float16_t(p);\n"
      "  return 0.3 * float(BODY);\n}\n";
  const auto with = [&](const std::string& body) {
    std::string out = text;
    return float_finding("own.glsl", out.replace(out.find("BODY"), 4, body));
  };
  EXPECT_EQ(with("x * x").verdict, "pass");
  EXPECT_THAT(with("x * x").statement, HasSubstr("with 16-bit types in half precision"));
  EXPECT_EQ(with("(1000.0hf + x) - 1000.0hf").verdict, "fail");
}

// A text that compiles only if mediump is ignored is not called accurate.
TEST(OwnHalf, IsUndecidedIfItIsNotEvaluated) {
  const FloatFinding f =
      float_finding("old.glsl",
                    "//: param sampler 0.1 1 0.5\nfloat brdf(vec3 L, vec3 V, vec3 N, float sampler) {\n"
                    "  mediump float c = sampler * 0.3;\n  return c;\n}\n");
  EXPECT_EQ(f.verdict, "undecided");
  EXPECT_THAT(f.statement, HasSubstr("half precision is not evaluated"));
}

TEST(OwnHalf, AProofInFloatDoesNotClaimIt) {
  io::TemporaryFolder folder;
  std::ofstream(folder.path() / "a.glsl")
      << "//: param p 0.1 1 0.5\nfloat brdf(vec3 L, vec3 V, vec3 N, mediump float p) { return p * 0.3; }\n";
  std::ofstream(folder.path() / "b.glsl")
      << "//: param p 0.1 1 0.5\nfloat brdf(vec3 L, vec3 V, vec3 N, float p) { return p * 0.3; }\n";
  const Outcome narrow = run_brdf("prove --shader a.glsl --property finite", folder.path());
  EXPECT_THAT(narrow.out, HasSubstr("does not enclose half precision"));
  EXPECT_EQ(run_brdf("prove --shader a.glsl --require finite", folder.path()).exit_code, 1);
  EXPECT_THAT(run_brdf("prove --shader b.glsl --property finite", folder.path()).out,
              Not(HasSubstr("half precision")));
  EXPECT_EQ(run_brdf("prove --shader b.glsl --require finite", folder.path()).exit_code, 0);
}

}  // namespace
}  // namespace brdf
#endif
