// Tests the findings about a user's shader: whether the model or its arithmetic causes a finding, which
// findings void others, and the place that is reported.
#ifdef BRDF_HAS_SHADER
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>

#include "tests/cli/run_brdf.h"

namespace brdf {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

struct Judged {
  std::map<std::string, std::string> verdict, statement;
  std::map<std::string, std::string> command;  // of the witness
  int exit_code = 0;
};

Judged judged(const io::TemporaryFolder& folder, const std::string& text, const std::string& options = "") {
  std::ofstream(folder.path() / "own.glsl") << text;
  const Outcome o = run_brdf("validate --shader own.glsl --json " + options, folder.path());
  Judged j;
  j.exit_code = o.exit_code;
  const nlohmann::json all = nlohmann::json::parse(o.out, nullptr, false);
  EXPECT_FALSE(all.is_discarded()) << o.err;
  for (const auto& f : all["findings"]) {
    j.verdict[f["check"]] = f["verdict"];
    j.statement[f["check"]] = f["statement"];
    if (f["witness"].is_object()) j.command[f["check"]] = f["witness"]["command"];
  }
  return j;
}

std::string with_body(const std::string& body) {
  return "//: param p 0 1 0.5\nfloat brdf(vec3 L, vec3 V, vec3 N, float p) { " + body + " }\n";
}

TEST(OwnFindings, TheLightIsTurnedWhereNothingShowsThatItMayStay) {
  io::TemporaryFolder folder;
  const Judged j = judged(folder, with_body("return L.y < -0.4 ? -0.3 : 0.15 * p;"));
  EXPECT_EQ(j.verdict.at("non_negative"), "fail");
  EXPECT_EQ(j.verdict.at("isotropy"), "fail");
  EXPECT_THAT(j.statement.at("isotropy"), HasSubstr("although the shader reads no tangent"));
  const Judged bright = judged(folder, with_body("return (0.3 + 2.0 * L.x * L.x) / 3.14159265;"));
  EXPECT_EQ(bright.verdict.at("energy"), "fail");
  const Judged sound =
      judged(folder, with_body("return p * (1.2 + L.z * V.z + L.x * V.x + L.y * V.y) / 7.0;"));
  EXPECT_EQ(sound.verdict.at("isotropy"), "pass");
  EXPECT_EQ(sound.exit_code, 0);
}

// The shader is isotropic in real numbers, but in float only the light at azimuth 0 has no overflow.
TEST(OwnFindings, FloatIsJudgedAtEveryAzimuthOfTheLight) {
  io::TemporaryFolder folder;
  const std::string head = "float a = L.y * 3e22 * 4e21, b = L.y * 3e22 * 4e21; ";
  const Judged infinite = judged(folder, with_body(head + "return 0.1 * p + 1e-36 * (a - b);"));
  EXPECT_EQ(infinite.verdict.at("isotropy"), "pass");
  EXPECT_EQ(infinite.verdict.at("float"), "fail") << infinite.statement.at("float");
  const Judged compared = judged(folder, with_body(head + "return a < b + 1e36 ? 0.1 * p : 0.3 * p;"));
  EXPECT_EQ(compared.verdict.at("float"), "fail") << compared.statement.at("float");
}

TEST(OwnFindings, SignsAreJudgedAtEveryAzimuthOfTheLight) {
  io::TemporaryFolder folder;
  // Isotropic in real numbers; a and b overflow unless the light is at azimuth 0.
  const std::string head = "float a = 1e30 * L.y; for (int k = 0; k < 200; ++k) a *= 1e30; ";
  const Judged j = judged(folder, with_body(head + "return a < a + 1e30 ? 0.1 * p : -0.2;"));
  EXPECT_EQ(j.verdict.at("non_negative"), "fail") << j.statement.at("non_negative");
}

// A ridge of 2e-5 in a coordinate of the half vector is seen by no search, but its condition is.
TEST(OwnFindings, ABranchThatTheSearchesHardlyMeetVoidsTheirFindings) {
  io::TemporaryFolder folder;
  const auto with_ridge = [&](const std::string& inside) {
    return judged(folder, with_body("vec3 H = normalize(L + V); float f = 0.3 * p / 3.14159265;\n"
                                    "if (abs(H.x - 0.3721) < 1e-5) " +
                                    inside + "\nreturn f;"));
  };
  const Judged bright = with_ridge("f *= 1e6;");
  for (const char* check : {"energy", "reciprocity", "continuity"}) {
    EXPECT_EQ(bright.verdict.at(check), "undecided") << check << ": " << bright.statement.at(check);
    EXPECT_THAT(bright.statement.at(check), HasSubstr("line 3, `if (abs(H.x - 0.3721) < 1e-5)")) << check;
  }
  EXPECT_EQ(with_ridge("f = -f;").verdict.at("non_negative"), "fail");
  EXPECT_EQ(with_ridge("f /= L.z - L.z;").verdict.at("finite"), "fail");
  // Both conditions hold at a few directions only, and the second is met only where the first holds.
  EXPECT_EQ(with_ridge("if (abs(H.y - 0.1) < 1e-5) f *= 1e9;").verdict.at("energy"), "undecided");
  // A branch that changes nothing visible decides nothing, nor does a guard.
  EXPECT_EQ(with_ridge("f *= 1.0001;").verdict.at("energy"), "pass");
  const Judged guarded =
      judged(folder,
             with_body("if (L.z <= 0.0 || V.z <= 0.0) return 0.0; vec3 H = normalize(L + V); float s = 1.0 - "
                       "H.z * H.z;\nif (s < 1e-7) s = 1e-7; if (s > 2.0) return 1e9;\n"
                       "return p * (0.2 + 0.1 * sqrt(s));"));
  for (const char* check : {"energy", "non_negative", "reciprocity", "continuity", "float"})
    EXPECT_EQ(guarded.verdict.at(check), "pass") << check << ": " << guarded.statement.at(check);
}

TEST(OwnFindings, UndefinedValuesAreTheirOwnFindingAndVoidTheOthers) {
  io::TemporaryFolder folder;
  const Judged j = judged(folder, with_body("float s; if (V.z < 0.6) s = 0.2 * p; return s;"));
  EXPECT_EQ(j.exit_code, 1);
  EXPECT_EQ(j.verdict.at("undefined"), "fail");
  EXPECT_THAT(j.statement.at("undefined"), HasSubstr("line 2"));
  for (const char* check : {"finite", "non_negative", "energy"})
    EXPECT_EQ(j.verdict.at(check), "undecided") << check;
  // If values are undefined only on a set of directions without area, the other findings are not voided.
  const Judged normal =
      judged(folder, with_body("return 0.1 + 0.05 * p * sin(2.0 * atan(L.y, L.x)) * (1.0 - L.z);"));
  EXPECT_EQ(normal.verdict.at("undefined"), "fail");
  EXPECT_THAT(normal.statement.at("undefined"),
              HasSubstr("coincide, are mirror directions or include the normal"));
  EXPECT_EQ(normal.verdict.at("finite"), "pass");
  // `finite` must not fail for a value that is only undetermined.
  EXPECT_NE(judged(folder, with_body("return p * pow(V.z - 3.0, 2.0);")).verdict.at("finite"), "fail");
}

TEST(OwnFindings, TheHorizonIsToldApartAndDoesNotHideTheHemisphere) {
  io::TemporaryFolder folder;
  const Judged edge = judged(folder, with_body("return 0.2 * p * V.z / (V.z + L.z);"), "--require finite");
  EXPECT_EQ(edge.verdict.at("finite"), "pass");
  EXPECT_THAT(edge.statement.at("finite"), HasSubstr("at the exact horizon f is not finite: line 2"));
  const Judged both = judged(
      folder, with_body("float c = 0.2 * V.z / (V.z + L.z); if (p > 0.7) return c + 0.1 * sqrt(L.z - V.z);\n"
                        "return c;"));
  EXPECT_EQ(both.verdict.at("finite"), "fail");
  EXPECT_THAT(both.statement.at("finite"), HasSubstr("of the pairs inside the hemisphere: line 2"));
  EXPECT_EQ(both.verdict.at("energy"), "undecided");
}

TEST(OwnFindings, CoincidentDirectionsAreSearched) {
  io::TemporaryFolder folder;
  const Judged j = judged(folder, with_body("return 0.1 + 0.05 * p * acos(dot(V, L));"));
  EXPECT_EQ(j.verdict.at("finite"), "fail");
  EXPECT_THAT(j.statement.at("finite"), HasSubstr("coincide"));
  // The command of the witness must reproduce a value that is not a number.
  const std::string command = j.command.at("finite");
  const std::string rows = command.substr(command.find("'") + 1, command.find("' >") - command.find("'") - 1);
  std::string table = rows;
  for (std::size_t at; (at = table.find("\\n")) != std::string::npos;) table.replace(at, 2, "\n");
  std::ofstream(folder.path() / "pair.csv") << table;
  const Outcome o = run_brdf(command.substr(command.find("brdf eval") + 5), folder.path());
  EXPECT_THAT(o.out, HasSubstr("nan"));
}

// dot(V, H) equals dot(L, H) for unit vectors. Both lose their digits at grazing angles from opposite
// sides.
constexpr const char* kReciprocal = R"(//: param r 0.1 1 0.4
float brdf(vec3 L, vec3 V, vec3 N, float r) {
  vec3 H = normalize(L + V);
  return 1e-5 * r / (1e-5 + max(dot(V, H), 0.0)) * SKEW;
}
)";

TEST(OwnFindings, RoundingIsNotTakenForTheModel) {
  io::TemporaryFolder folder;
  std::string text = kReciprocal;
  const std::size_t at = text.find("SKEW");
  const Judged j = judged(folder, std::string(text).replace(at, 4, "1.0"));
  EXPECT_EQ(j.verdict.at("reciprocity"), "pass") << j.statement.at("reciprocity");
  EXPECT_THAT(j.statement.at("reciprocity"), HasSubstr("which is rounding"));
  // An error of the model of the same size must still fail.
  EXPECT_EQ(
      judged(folder, std::string(text).replace(at, 4, "(1.0 + 0.0001 * L.z)")).verdict.at("reciprocity"),
      "fail");
}

TEST(OwnFindings, EnergyOfCodeThatIsNotReciprocalIsToldForBothDirections) {
  io::TemporaryFolder folder;
  const Judged j = judged(folder, with_body("return p * 1.5 * V.z / 3.14159265;"));
  EXPECT_EQ(j.verdict.at("energy"), "fail");
  EXPECT_THAT(j.statement.at("energy"), HasSubstr("at fixed incidence: largest directional albedo found: 1"));
  EXPECT_THAT(j.statement.at("energy"),
              HasSubstr("at fixed viewing direction: directional albedo up to 1.5"));
  EXPECT_THAT(judged(folder, with_body("return 0.002 * p;")).statement.at("energy"),
              HasSubstr("nearly all light is lost"));
}

TEST(OwnFindings, AFunctionThatIsZeroPassesNothing) {
  io::TemporaryFolder folder;
  const Judged j = judged(folder, with_body("return 0.0 * p;"));
  for (const auto& [check, verdict] : j.verdict) EXPECT_NE(verdict, "pass") << check;
  EXPECT_THAT(j.statement.at("finite"), StartsWith("vacuous"));
}

TEST(OwnFindings, ASearchThatIsCutShortPassesNothing) {
  io::TemporaryFolder folder;
  const std::string sound = with_body("return p / 3.14159266;");
  const Judged j = judged(folder, sound, "--seconds 1e-9");
  for (const char* check : {"finite", "undefined", "non_negative", "reciprocity", "energy", "continuity"}) {
    EXPECT_EQ(j.verdict.at(check), "undecided") << check;
    EXPECT_THAT(j.statement.at(check), HasSubstr("points examined; a larger --seconds examines more"))
        << check;
  }
  EXPECT_EQ(judged(folder, sound, "--seconds 1e-9 --require energy").exit_code, 1);
  EXPECT_EQ(judged(folder, with_body("return -p;"), "--seconds 1e-9").verdict.at("non_negative"), "fail");
  EXPECT_EQ(judged(folder, sound, "--seconds 600").verdict.at("energy"), "pass");
}

TEST(OwnRoles, AWidthAcrossNeedsOneAlong) {
  io::TemporaryFolder folder;
  for (const char* role : {"width_across", "exponent_across"}) {
    std::ofstream(folder.path() / "own.glsl")
        << "//: param s 0.2 0.8 0.4 role " << role
        << "\nfloat brdf(vec3 L, vec3 V, vec3 N, float s) { return 0.1 * s; }\n";
    const Outcome o = run_brdf("validate --shader own.glsl -o page.html", folder.path());
    EXPECT_EQ(o.exit_code, 2);
    EXPECT_THAT(o.err,
                HasSubstr("own.glsl:1: param s: role " + std::string(role) + " needs another parameter"));
  }
}

TEST(OwnRoles, EveryRoleHasAPage) {
  io::TemporaryFolder folder;
  for (const char* role :
       {"diffuse", "specular", "f0", "width", "exponent", "slope", "index", "extinction", "other"}) {
    std::ofstream(folder.path() / "own.glsl") << "//: param s 0.2 0.8 0.4 role " << role
                                              << "\nfloat brdf(vec3 L, vec3 V, vec3 N, float s) { return "
                                                 "exp(-2.0 * s) * (0.1 + 0.1 * L.z * V.z * sin(s)); }\n";
    const Outcome o = run_brdf("validate --shader own.glsl -o page.html", folder.path());
    EXPECT_EQ(o.exit_code, 0) << role << o.err;
    EXPECT_THAT(file_text(folder.path() / "page.html"), HasSubstr("own.glsl")) << role;
  }
}

TEST(OwnProofs, SayWhatIsUndefined) {
  io::TemporaryFolder folder;
  std::ofstream(folder.path() / "own.glsl")
      << with_body("float a[2] = float[2](0.1, 0.2); return a[int(3.0 * L.z)];");
  const Outcome o = run_brdf("prove --shader own.glsl --property finite --require finite", folder.path());
  EXPECT_EQ(o.exit_code, 1);
  EXPECT_THAT(o.out, HasSubstr("undefined: line 2"));
  EXPECT_THAT(o.out, Not(HasSubstr("proved")));
}

TEST(OwnProofs, TheSelfTestTakesNothingElse) {
  io::TemporaryFolder folder;
  EXPECT_THAT(run_brdf("prove --self-test --form ward", folder.path()).err,
              HasSubstr("has no effect with --self-test"));
  EXPECT_THAT(run_brdf("prove --seed 3 --form ward", folder.path()).err,
              HasSubstr("--seed: applies to --self-test only"));
}

}  // namespace
}  // namespace brdf
#endif
