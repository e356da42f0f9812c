// Tests a user's shader in directions without a finite value, and in comparison with forms of narrower
// parameter ranges.
#ifdef BRDF_HAS_SHADER
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/cli/run_brdf.h"

namespace brdf {
namespace {

using testing::HasSubstr;
using testing::Not;

void write_text(const std::filesystem::path& file, const std::string& text) {
  std::ofstream(file) << text;
}

nlohmann::json finding_of(const std::string& out, const std::string& check) {
  const nlohmann::json all = nlohmann::json::parse(out);
  for (const auto& f : all["findings"])
    if (f["check"] == check) return f;
  return nullptr;
}

// 0/0 along the normal, infinite if both polar angles are 40 degrees, minus infinity at 60 degrees.
constexpr const char* kOpen =
    "//: param level 0 1 0.25\n"
    "float brdf(vec3 L, vec3 V, vec3 N, float level) {\n"
    "  float d = 1.0 - dot(N, L);\n"
    "  if (d < 0.1) return level * d / d;\n"
    "  if (d < 0.4) return level / (dot(N, V) - dot(N, L));\n"
    "  return log(dot(N, V) - dot(N, L));\n"
    "}\n";
constexpr const char* kPairs = "theta_i,phi_i,theta_o,phi_o\n10,0,20,0\n0,0,20,0\n40,0,40,0\n60,0,60,0\n";

TEST(EvalNotFinite, IsWrittenRowByRowAndCounted) {
  io::TemporaryFolder folder;
  write_text(folder.path() / "open.glsl", kOpen);
  write_text(folder.path() / "pairs.csv", kPairs);
  const Outcome o = run_brdf("eval --shader open.glsl pairs.csv -o values.csv", folder.path());
  EXPECT_EQ(o.exit_code, 1);
  EXPECT_THAT(o.err, HasSubstr("3 of 4 values are no finite number; the first: pairs.csv, line 3: f nan"));
  EXPECT_THAT(file_text(folder.path() / "values.csv"),
              HasSubstr("10,0,20,0,0.25\n0,0,20,0,nan\n40,0,40,0,inf\n60,0,60,0,-inf\n"));
  const Outcome printed = run_brdf("eval --shader open.glsl pairs.csv", folder.path());
  EXPECT_EQ(printed.exit_code, 1);
  EXPECT_THAT(printed.out, HasSubstr("\n0,0,20,0,nan\n"));
}

TEST(EvalNotFinite, FiniteValuesAreGood) {
  io::TemporaryFolder folder;
  write_text(folder.path() / "open.glsl", kOpen);
  write_text(folder.path() / "pairs.csv", "theta_i,phi_i,theta_o,phi_o\n10,0,20,0\n");
  const Outcome o = run_brdf("eval --shader open.glsl pairs.csv", folder.path());
  EXPECT_EQ(o.exit_code, 0);
  EXPECT_THAT(o.err, Not(HasSubstr("no finite number")));
}

TEST(EvalFloat, PrintsTheValuesOfSinglePrecision) {
  io::TemporaryFolder folder;
  write_text(
      folder.path() / "small.glsl",
      "//: param p 1 3 2\nfloat brdf(vec3 L, vec3 V, vec3 N, float p) { return (1.0 + 2e-10 * p) - 1.0 == "
      "0.0 ? 0.25 : 0.5; }\n");
  write_text(folder.path() / "pairs.csv", "theta_i,phi_i,theta_o,phi_o\n10,0,20,0\n");
  const auto run = [&](const std::string& options) {
    return run_brdf("eval --shader small.glsl " + options + " pairs.csv", folder.path());
  };
  EXPECT_THAT(run("").out, HasSubstr("\n10,0,20,0,0.5\n"));
  EXPECT_THAT(run("--float").out, HasSubstr("\n10,0,20,0,0.25\n"));
  EXPECT_EQ(run("--float --cos").exit_code, 2);
  EXPECT_EQ(run_brdf("eval --form lambert --float pairs.csv", folder.path()).exit_code, 2);
}

// The command of a witness in float prints the value of float.
TEST(EvalFloat, WitnessesOfProofsReproduce) {
  io::TemporaryFolder folder;
  write_text(
      folder.path() / "small.glsl",
      "//: param p 1 3 2\nfloat brdf(vec3 L, vec3 V, vec3 N, float p) { return (1.0 + 2e-10 * p) - 1.0 == "
      "0.0 ? -0.25 : 0.5; }\n");
  const Outcome o = run_brdf("prove --shader small.glsl --property non_negative --json", folder.path());
  const nlohmann::json all = nlohmann::json::parse(o.out);
  const nlohmann::json& in_float = all["results"][0];
  ASSERT_EQ(in_float["verdict"], "refuted") << o.out;
  EXPECT_EQ(in_float["witness"]["value"], -0.25);
  EXPECT_THAT(std::string(in_float["witness"]["command"]), HasSubstr(" --float -"));
  EXPECT_EQ(all["results"][1]["verdict"], "proved");
}

TEST(EvalNotFinite, IsNoMeasurement) {
  io::TemporaryFolder folder;
  write_text(folder.path() / "open.glsl", kOpen);
  write_text(folder.path() / "pairs.csv", kPairs);
  run_brdf("eval --shader open.glsl pairs.csv -o values.csv", folder.path());
  for (const char* verb :
       {"fit values.csv --form lambert", "validate values.csv", "convert values.csv out.csv"}) {
    const Outcome o = run_brdf(verb, folder.path());
    EXPECT_EQ(o.exit_code, 2) << verb;
    EXPECT_THAT(o.err, HasSubstr("'nan' is not finite; omit the rows of directions that were not measured"))
        << verb;
  }
}

TEST(EvalNotFinite, WitnessesOfFiniteReproduce) {
  io::TemporaryFolder folder;
  write_text(folder.path() / "open.glsl", kOpen);
  const Outcome o = run_brdf("validate --shader open.glsl --json", folder.path());
  const std::string command = finding_of(o.out, "finite")["witness"]["command"];
  const std::size_t eval = command.find("brdf eval ");
  ASSERT_NE(eval, std::string::npos) << command;
  ASSERT_EQ(
      std::system(("cd '" + folder.path().string() + "' && " + command.substr(0, eval) + "true").c_str()), 0);
  const Outcome again = run_brdf(command.substr(eval + 5), folder.path());
  EXPECT_EQ(again.exit_code, 1) << command;
  EXPECT_THAT(again.out, testing::AnyOf(HasSubstr(",nan\n"), HasSubstr("inf\n"))) << command;
}

// The form oren_nayar with `depth` for sigma and `tint` for rho. The range of `depth` extends beyond the
// range of sigma at both ends, and the shader is twice as bright for negative `depth`.
constexpr const char* kWide =
    "//: param depth -3 5 0.5\n"
    "//: param tint 0 1 0.5\n"
    "float brdf(vec3 L, vec3 V, vec3 N, float depth, float tint) {\n"
    "  float s = dot(L, V) - dot(N, L) * dot(N, V), d2 = depth * depth;\n"
    "  float a = 1.0 - 0.5 * d2 / (d2 + 0.33), b = 0.45 * d2 / (d2 + 0.09);\n"
    "  float m = max(max(dot(N, L), dot(N, V)), 1e-30);\n"
    "  return tint * (a + b * max(s, 0.0) / m) * (depth < 0.0 ? 2.0 : 1.0) / 3.14159265;\n"
    "}\n";

TEST(Against, LeavesOutParametersThatTheFormDoesNotHave) {
  io::TemporaryFolder folder;
  write_text(folder.path() / "wide.glsl", kWide);
  const Outcome o =
      run_brdf("validate --shader wide.glsl --against oren_nayar --map rho=tint --map sigma=depth --json",
               folder.path());
  const nlohmann::json f = finding_of(o.out, "against");
  EXPECT_EQ(f["verdict"], "pass") << f << o.err;
  const std::string said = f["statement"];
  EXPECT_THAT(said, HasSubstr("compared for rho 0 to 1, sigma "));
  EXPECT_THAT(said, HasSubstr(" to 1.571 ("));
  EXPECT_THAT(said, HasSubstr("are outside the form's ranges and are left out"));
}

TEST(Against, StillSeesADifferenceInsideTheRange) {
  io::TemporaryFolder folder;
  write_text(folder.path() / "wide.glsl", kWide);
  const Outcome o =
      run_brdf("validate --shader wide.glsl --against oren_nayar --map rho=tint --map sigma=-depth --json",
               folder.path());
  const nlohmann::json f = finding_of(o.out, "against");
  EXPECT_EQ(f["verdict"], "fail") << f;  // twice as bright there
  EXPECT_NEAR(f["value"].get<double>(), 0.5, 1e-3);
}

TEST(Against, NamesDefaultsThatNothingSets) {
  io::TemporaryFolder folder;
  write_text(folder.path() / "wide.glsl", kWide);
  const Outcome o =
      run_brdf("validate --shader wide.glsl --against oren_nayar --map rho=tint --json", folder.path());
  EXPECT_THAT(finding_of(o.out, "against")["statement"].get<std::string>(),
              HasSubstr("the form's defaults: sigma = "));
}

TEST(Against, RefusesWhatDoesNotOverlap) {
  io::TemporaryFolder folder;
  write_text(folder.path() / "wide.glsl", kWide);
  const Outcome o = run_brdf(
      "validate --shader wide.glsl --against oren_nayar --map rho=tint --map sigma=depth+5", folder.path());
  EXPECT_EQ(o.exit_code, 2);
  EXPECT_THAT(o.err, HasSubstr("nothing can be compared"));
  EXPECT_THAT(o.err, HasSubstr("sigma would be 2"));
  EXPECT_THAT(o.err, Not(HasSubstr("rho would be")));
}

// The range that both have in common is about 0.2 % of the range of `depth`.
TEST(Against, FindsAThinOverlap) {
  io::TemporaryFolder folder;
  write_text(folder.path() / "wide.glsl", kWide);
  const Outcome o = run_brdf(
      "validate --shader wide.glsl --against oren_nayar --map rho=tint --map sigma=depth+1.5627 --param "
      "depth=0:5 "
      "--json",
      folder.path());
  const nlohmann::json f = finding_of(o.out, "against");
  EXPECT_EQ(f["verdict"], "fail") << o.err << f;
  EXPECT_THAT(f["statement"].get<std::string>(), HasSubstr("sigma 1.56"));
}

}  // namespace
}  // namespace brdf
#endif
