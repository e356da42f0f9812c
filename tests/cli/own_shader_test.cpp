// Tests the verbs with a user's shader.
#ifdef BRDF_HAS_SHADER
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "brdf/reflectance.h"
#include "io/files/json.h"
#include "tests/cli/run_brdf.h"

namespace brdf {
namespace {

using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

const std::string kShaders = "'" BRDF_SOURCE_DIR "/data/shaders/";

nlohmann::json finding(const std::string& out, const std::string& check) {
  const nlohmann::json all = nlohmann::json::parse(out);
  for (const auto& f : all["findings"])
    if (f["check"] == check) return f;
  return nullptr;
}

TEST(OwnShader, ASoundOnePasses) {
  io::TemporaryFolder folder;
  const Outcome o = run_brdf("validate --shader " + kShaders +
                                 "sound.glsl' --such-that 'kd + ks <= 1' --require "
                                 "finite,non_negative,reciprocity,energy,isotropy,float --json",
                             folder.path());
  EXPECT_EQ(o.exit_code, 0) << o.out << o.err;
  // A grey diffuse reflector returns all light.
  EXPECT_NEAR(finding(o.out, "energy")["value"].get<double>(), 1, 1e-3);
  // Without the condition, kd and ks may both be 1.
  const Outcome free = run_brdf("validate --shader " + kShaders + "sound.glsl' --json", folder.path());
  EXPECT_EQ(free.exit_code, 1);
  EXPECT_GT(finding(free.out, "energy")["value"].get<double>(), 1.5);
}

// A search that ended within the tolerance of the condition found values beyond its edge.
TEST(OwnShader, NoWitnessLiesBeyondTheEdgeOfACondition) {
  io::TemporaryFolder folder;
  std::ofstream(folder.path() / "s.glsl")
      << "//: param a 0 1 0.5\n//: param b 0 1 0.25\nfloat brdf(vec3 L, vec3 V, vec3 N, float a, float b) {\n"
         "  return 2.0*a + b > 2.0 ? 0.6 : 0.05*b;\n}\n";
  const Outcome o = run_brdf("validate --shader s.glsl --such-that '2*a + b <= 2' --json", folder.path());
  EXPECT_EQ(finding(o.out, "energy")["verdict"], "pass") << finding(o.out, "energy");
}

TEST(OwnShader, ValuesThatAreNoNumbersAreNotComparedSilently) {
  io::TemporaryFolder folder;
  std::ofstream(folder.path() / "s.glsl")
      << "float brdf(vec3 L, vec3 V, vec3 N) { return log(-L.z * V.z) * (L.x > 0.0 ? 1.0 : -1.0); }\n";
  const Outcome o = run_brdf("validate --shader s.glsl --json", folder.path());
  for (const char* check : {"non_negative", "reciprocity", "isotropy", "continuity", "float"})
    EXPECT_EQ(finding(o.out, check)["verdict"], "undecided") << finding(o.out, check);
}

TEST(OwnShader, AClampedProductIsFoundWithTheCommandThatShowsIt) {
  io::TemporaryFolder folder;
  const Outcome o =
      run_brdf("validate --shader " + kShaders + "clamped_dot.glsl' --max-theta 85 --json", folder.path());
  EXPECT_EQ(o.exit_code, 1);
  const auto energy = finding(o.out, "energy");
  EXPECT_NEAR(energy["value"].get<double>(), 1.1429, 1e-4);
  const std::string command = energy["witness"]["command"];
  ASSERT_TRUE(command.starts_with("brdf albedo --shader ")) << command;
  const Outcome shown = run_brdf(command.substr(5), folder.path());
  EXPECT_EQ(shown.exit_code, 0) << shown.err;
  EXPECT_THAT(shown.out, HasSubstr("1.1428498"));
}

TEST(OwnShader, FaultsNameTheirLine) {
  io::TemporaryFolder folder;
  const auto judged = [&](const std::string& text, const std::string& check) {
    std::ofstream(folder.path() / "s.glsl") << text;
    const Outcome o = run_brdf("validate --shader s.glsl --json", folder.path());
    EXPECT_EQ(o.exit_code, 1) << o.err;
    return finding(o.out, check)["statement"].get<std::string>();
  };
  EXPECT_THAT(judged("float brdf(vec3 L, vec3 V, vec3 N) {\n  vec3 t = L - N * dot(N, L);\n  return 0.3 + "
                     "0.1 * dot(normalize(t), V);\n}\n",
                     "finite"),
              HasSubstr("line 3, `return 0.3 + 0.1 * dot(normalize(t), V);`: 0 / 0 = "));
  EXPECT_THAT(judged("float brdf(vec3 L, vec3 V, vec3 N) {\n  float s = dot(L, V);\n  return 0.3183 * (1.0 + "
                     "1.0553 * s);\n}\n",
                     "non_negative"),
              testing::AllOf(HasSubstr("f down to -0.0176"), HasSubstr("line 3")));
  EXPECT_THAT(judged("float brdf(vec3 L, vec3 V, vec3 N) {\n  float d = (1.0 + 1e-9 * dot(N, L)) - 1.0;\n  "
                     "return 1e-9 / d;\n}\n",
                     "float"),
              testing::AllOf(HasSubstr("not finite in float at directions at which double is finite"),
                             HasSubstr("line 3"), HasSubstr("/ 0 = inf")));
}

TEST(OwnShader, StepsWithinTheHemisphereHaveAPlace) {
  io::TemporaryFolder folder;
  const auto judged = [&](const std::string& text) {
    std::ofstream(folder.path() / "s.glsl") << text;
    return finding(run_brdf("validate --shader s.glsl --json", folder.path()).out, "continuity");
  };
  const auto edge = judged(
      "//: param edge 0.3 0.9 0.6\nfloat brdf(vec3 L, vec3 V, vec3 N, float edge) {\n  vec3 H = normalize(L "
      "+ V);\n"
      "  return dot(N, H) > edge ? 0.3 : 0.1;\n}\n");
  EXPECT_EQ(edge["verdict"], "fail");
  EXPECT_NEAR(edge["value"].get<double>(), 2.0 / 3, 1e-6);
  EXPECT_THAT(edge["statement"].get<std::string>(),
              testing::AllOf(HasSubstr("within the hemisphere; line 4, `return dot(N, H) > edge"),
                             HasSubstr(" passes ")));
  // The command prints two directions, one on either side of the step.
  const std::string command = edge["witness"]["command"];
  const std::size_t eval = command.find("brdf eval");
  ASSERT_NE(eval, command.npos);
  ASSERT_EQ(std::system(("cd '" + folder.path().string() + "' && " + command.substr(0, eval - 4)).c_str()),
            0);
  const Outcome shown = run_brdf(command.substr(eval + 5), folder.path());
  EXPECT_THAT(shown.out, testing::AllOf(HasSubstr("0.1"), HasSubstr("0.3"))) << shown.err;
  EXPECT_THAT(
      judged(
          "float brdf(vec3 L, vec3 V, vec3 N) {\n  float c = dot(N, L) * dot(N, V);\n  return 0.1 + 0.05 * "
          "floor(4.0 * c);\n}\n")["statement"]
          .get<std::string>(),
      HasSubstr("line 3"));
  EXPECT_EQ(
      judged("float brdf(vec3 L, vec3 V) { return L.y * V.x - L.x * V.y < 0.0 ? 0.1 : 0.2; }\n")["verdict"],
      "fail");
  // A narrow and steep lobe is not a step.
  EXPECT_EQ(judged("float brdf(vec3 L, vec3 V, vec3 N) { return 0.01 * exp(-1e5 * (1.0 - dot(N, normalize(L "
                   "+ V)))); }\n")["verdict"],
            "pass");
}

TEST(OwnShader, ThatHasNoAlbedoIsNotSound) {
  io::TemporaryFolder folder;
  const auto energy = [&](const std::string& value) {
    std::ofstream(folder.path() / "s.glsl")
        << "float brdf(vec3 L, vec3 V, vec3 N) { return " << value << "; }\n";
    return finding(run_brdf("validate --shader s.glsl --json", folder.path()).out, "energy");
  };
  EXPECT_EQ(energy("pow(dot(N, L) * dot(N, V), -2.0)")["verdict"], "fail");
  EXPECT_EQ(energy("sqrt(-1.0 - L.z)")["verdict"], "undecided");
  // The constant is rounded to float. A reflector that returns all light according to this constant does
  // not violate energy conservation.
  EXPECT_EQ(energy("1.0 / 3.14159265")["verdict"], "pass");
}

TEST(OwnShader, IsRefusedWithOneSentence) {
  io::TemporaryFolder folder;
  std::ofstream(folder.path() / "main.frag")
      << "#version 330 core\nout vec4 c;\nvoid main() { c = vec4(1.0); }\n";
  std::ofstream(folder.path() / "loop.glsl")
      << "float brdf(vec3 L, vec3 V) {\n  float s = 0.0;\n  while (s >= 0.0) s += 1.0;\n  return s;\n}\n";
  for (const auto& [file, sentence] : {std::pair("main.frag", "//: entry NAME"),
                                       std::pair("loop.glsl", "loop.glsl:3: this loop may not end")}) {
    const Outcome o = run_brdf(std::string("validate --shader ") + file, folder.path());
    EXPECT_EQ(o.exit_code, 2) << file;
    EXPECT_THAT(o.err, HasSubstr(sentence));
  }
  EXPECT_EQ(run_brdf("albedo --form ward --param a=0:1 --theta 0", folder.path()).exit_code, 2);
}

TEST(OwnShader, ThatTurnsWithItsTangentIsJudged) {
  io::TemporaryFolder folder;
  std::ofstream(folder.path() / "s.glsl") << "//: violates energy\nfloat brdf(vec3 L, vec3 V, vec3 N, vec3 "
                                             "X) { return 0.3 * (1.0 + dot(L, X) * dot(V, X)); }\n";
  const Outcome o = run_brdf("validate --shader s.glsl --json", folder.path());
  EXPECT_EQ(o.exit_code, 1) << o.err;
  EXPECT_EQ(finding(o.out, "reciprocity")["verdict"], "pass");
  // The shader declares a violation of energy conservation that it does not have: its albedo is 0.3 pi. The
  // declaration is false, and the finding fails.
  EXPECT_EQ(finding(o.out, "energy")["verdict"], "fail");
  EXPECT_NEAR(finding(o.out, "energy")["value"].get<double>(), 0.3 * 3.14159265, 1e-3);
}

TEST(OwnShader, ADeclaredViolationHasAValueAndAnAngle) {
  io::TemporaryFolder folder;
  const auto energy_with = [&](const std::string& declaration, const std::string& value) {
    std::ofstream(folder.path() / "s.glsl") << "//: violates energy" + declaration +
                                                   "\nfloat brdf(vec3 L, vec3 V, vec3 N) { return " + value +
                                                   "; }\n";
    return finding(run_brdf("validate --shader s.glsl --json", folder.path()).out, "energy");
  };
  const std::string twice = "2.0 / 3.14159265";
  EXPECT_EQ(energy_with(" up to 2", twice)["verdict"], "known_violation");
  const auto worse = energy_with(" up to 1.99 too bright", twice);
  EXPECT_EQ(worse["verdict"], "fail");
  EXPECT_THAT(worse["statement"].get<std::string>(),
              HasSubstr("; worse than declared up to 1.99: too bright"));
  const auto any = energy_with("", twice);
  EXPECT_EQ(any["verdict"], "known_violation");
  EXPECT_THAT(any["statement"].get<std::string>(),
              HasSubstr("without a value, so that any violation is a known"));
  // Too much light from 80 degrees on: at 85 as declared, but not at 70.
  const std::string grazing = "(L.z < 0.17 && V.z < 0.17 ? 30.0 : 0.3)";
  EXPECT_EQ(energy_with(" at 85", grazing)["verdict"], "known_violation");
  const auto later = energy_with(" at 70", grazing);
  EXPECT_EQ(later["verdict"], "fail");
  EXPECT_THAT(later["statement"].get<std::string>(), HasSubstr("not up to the angle that is declared at 70"));
}

TEST(OwnShader, IsDrawnAsItIsEvaluated) {
  io::TemporaryFolder folder;
  std::ofstream(folder.path() / "many.glsl")
      << "//: param n 0 1 1\nfloat brdf(vec3 L, vec3 V, vec3 N, float a, float b, float c, float d, int n) "
         "{\n  float t[3] = "
         "float[3](0.1, 0.2, 0.3), s = 0.0;\n  for (int k = 0; k < n + 2; ++k) { if (k == 1 && d > 0.2) "
         "continue; s "
         "+= t[k % 3] * a * b; }\n  return s * (1.0 + pow(c, 2.0) * d * L.z * V.z);\n}\n";
  {
    const Outcome o = run_brdf("parity --shader many.glsl", folder.path());
    if (o.exit_code == 3) GTEST_SKIP() << o.err;
    EXPECT_EQ(o.exit_code, 0) << o.out << o.err;
    EXPECT_EQ(o.out.find("FAILS"), std::string::npos) << o.out;
    EXPECT_THAT(o.out, HasSubstr("32 bits: relative MSE"));
  }
  const Outcome picture = run_brdf(
      "render --shader " + kShaders + "sound.glsl' --set roughness=0.3 --width 64 --height 64 -o s.png",
      folder.path());
  EXPECT_EQ(picture.exit_code, 0) << picture.err;
}

TEST(OwnShader, CostStandsBesideTheForms) {
  io::TemporaryFolder folder;
  std::ofstream(folder.path() / "plain.glsl")
      << "float brdf(vec3 L, vec3 V, vec3 N, float k) { return k * (0.25 + 0.5 * L.z * V.z); }\n";
  const Outcome o = run_brdf("validate --shader plain.glsl --gpu --json", folder.path());
  if (o.exit_code == 3) GTEST_SKIP() << o.err;
  ASSERT_EQ(o.exit_code, 0) << o.err;
  const auto json = nlohmann::json::parse(o.out);
  EXPECT_EQ(json["rows"][0]["differing"], 0);
  const auto& costs = json["costs"];
  ASSERT_EQ(costs.size(), 1 + catalogue().size());
  EXPECT_EQ(costs[0]["name"], "plain");
  // Two products, a sum and a product; a copy of the result, and the end.
  EXPECT_EQ(costs[0]["operations"], 6);
  for (const auto& c : costs) EXPECT_GT(c["driver_ns"].get<double>(), 0) << c;
  for (std::size_t k = 2; k < costs.size(); ++k)
    EXPECT_LE(costs[k - 1]["operations"], costs[k]["operations"]);
}

// The device takes three weights and four shapes as arguments; the others are constants of its formula.
TEST(OwnShader, ParametersThatTheDeviceHoldsChangeNoBit) {
  io::TemporaryFolder folder;
  std::ofstream(folder.path() / "many.glsl")
      << "//: param a 0 1 0.3\n//: param b 0 1 0.7\n//: param c 0 1 0.1\n//: param d 0 1 0.9\n"
         "//: param e 0 1 0.6\n//: param s 0 1 0.2\n//: param t 0 1 0.4\n//: param u 0 1 0.8\n"
         "//: param v 0 1 0.5\n//: param x 0 1 0.35\n"
         "float brdf(vec3 L, vec3 V, vec3 N, float a, float b, float c, float d, float e, float s, float t, "
         "float u, float v, float x) {\n"
         "  precise float shapes = (1.0 + s * s * t) * (1.0 + u * u * v) * (1.0 + x * x * L.z * V.z);\n"
         "  precise float f = (a + b * L.z * V.z + c * (L.z + V.z) + d * L.x * V.x + e * L.y * V.y) * "
         "shapes;\n"
         "  return f;\n}\n";
  const Outcome o = run_brdf("validate --shader many.glsl --gpu", folder.path());
  if (o.exit_code == 3) GTEST_SKIP() << o.err;
  ASSERT_EQ(o.exit_code, 0) << o.err;
  EXPECT_THAT(o.out, AllOf(ContainsRegex("many +[0-9]{7,} +0 +0 +0\n"), Not(HasSubstr("causes"))));
}

TEST(OwnShader, ADifferenceOnTheDeviceHasNoCauseThatWasNotExamined) {
  io::TemporaryFolder folder;
  std::ofstream(folder.path() / "arcs.glsl")
      << "//: param k 0 1 0.3\nfloat brdf(vec3 L, vec3 V, vec3 N, float k) { return k * acos(L.z) * "
         "acos(V.z); }\n";
  const Outcome o = run_brdf("validate --shader arcs.glsl --gpu", folder.path());
  if (o.exit_code == 3) GTEST_SKIP() << o.err;
  EXPECT_THAT(o.out,
              AllOf(ContainsRegex("arcs +[0-9]{7,} +[0-9]{4,} "), HasSubstr("The causes were not examined."),
                    Not(HasSubstr("cause the differences"))));
}

TEST(OwnShader, IsComparedWithAForm) {
  io::TemporaryFolder folder;
  const Outcome o =
      run_brdf("validate --shader " + kShaders +
                   "sound.glsl' --against cook_torrance --map 'alpha=roughness*roughness' --json",
               folder.path());
  EXPECT_EQ(finding(o.out, "against")["verdict"], "pass") << o.out << o.err;
  const Outcome other = run_brdf(
      "validate --shader " + kShaders + "sound.glsl' --against cook_torrance --map alpha=roughness --json",
      folder.path());
  EXPECT_EQ(finding(other.out, "against")["verdict"], "fail");
  EXPECT_GT(finding(other.out, "against")["value"].get<double>(), 0.5);
}

TEST(OwnShader, IsFittedToTheSamplesThatItMade) {
  io::TemporaryFolder folder;
  const std::string shader = "--shader " + kShaders + "wrong_norm.brdf'";
  ASSERT_EQ(run_brdf("synth " + shader +
                         " --set kd=0.2 --set ks=0.6 --set exponent=37 --grid in_plane --noise 0 -o s.csv",
                     folder.path())
                .exit_code,
            0);
  const Outcome o = run_brdf("fit s.csv " + shader + " --json", folder.path());
  EXPECT_EQ(o.exit_code, 1) << o.err;  // the normalisation of its lobe is wrong
  const auto best = nlohmann::json::parse(o.out)["ranking"][0], material = best["material"];
  EXPECT_EQ(best["verdict"], "breaks_energy");
  EXPECT_NEAR(material["weights"]["kd"][0].get<double>(), 0.2, 1e-6);
  EXPECT_NEAR(material["weights"]["ks"][0].get<double>(), 0.6, 1e-6);
  EXPECT_NEAR(material["shape"]["exponent"].get<double>(), 37, 1e-4);
}

TEST(OwnShader, MacrosAndIncludeFoldersBelongToTheCommand) {
  io::TemporaryFolder folder;
  std::filesystem::create_directories(folder.path() / "far");
  std::ofstream(folder.path() / "far" / "part.glsl") << "float part(float x) { return SCALE * x; }\n";
  std::ofstream(folder.path() / "s.glsl") << "#include \"part.glsl\"\n//: param kd 0 1 0.5\nfloat brdf(vec3 "
                                             "L, vec3 V, vec3 N, float kd) { return part(kd); }\n";
  std::ofstream(folder.path() / "d.csv") << "theta_i,phi_i,theta_o,phi_o\n10,0,20,0\n";
  const std::string words = " --shader s.glsl --define SCALE=0.75 -I far ";
  const Outcome eval = run_brdf("eval" + words + "d.csv", folder.path());
  EXPECT_EQ(eval.exit_code, 0) << eval.err;
  EXPECT_THAT(eval.out, HasSubstr(",0.375"));
  EXPECT_EQ(run_brdf("albedo" + words + "--theta 30", folder.path()).exit_code, 0);
  EXPECT_EQ(run_brdf("prove" + words + "--property finite --require finite", folder.path()).exit_code, 0);
  // If a value violates energy conservation, the command of the witness repeats all of these options and
  // reproduces the value.
  const Outcome judged = run_brdf("validate" + words + "--json", folder.path());
  const std::string command = finding(judged.out, "energy")["witness"]["command"];
  EXPECT_THAT(command, HasSubstr("--shader s.glsl --define SCALE=0.75 -I far"));
  const Outcome shown = run_brdf(command.substr(5), folder.path());
  EXPECT_EQ(shown.exit_code, 0) << shown.err;
  EXPECT_THAT(run_brdf("eval --shader s.glsl -I far d.csv", folder.path()).err,
              HasSubstr("part.glsl:1: 'SCALE'"));
  EXPECT_THAT(run_brdf("models --define SCALE=1", folder.path()).err,
              HasSubstr("--define: needs --shader FILE"));
  EXPECT_THAT(run_brdf("models -I far", folder.path()).err, HasSubstr("-I: needs --shader FILE"));
}

TEST(OwnShader, IntegersAreJudgedAtWholeNumbers) {
  io::TemporaryFolder folder;
  std::ofstream(folder.path() / "s.glsl") << "//: param kind 0 4 1\nfloat brdf(vec3 L, vec3 V, vec3 N, int "
                                             "kind, bool on) {\n  return on && kind == 3 ? -0.25 : "
                                             "0.25;\n}\n";
  std::ofstream(folder.path() / "d.csv") << "theta_i,phi_i,theta_o,phi_o\n10,0,20,0\n";
  const Outcome o = run_brdf("validate --shader s.glsl --json", folder.path());
  const auto negative = finding(o.out, "non_negative");
  EXPECT_EQ(negative["verdict"], "fail");
  EXPECT_THAT(negative["witness"]["command"].get<std::string>(), HasSubstr("--set kind=3 --set on=1"));
  EXPECT_THAT(run_brdf("eval --shader s.glsl --set kind=2.5 d.csv", folder.path()).err,
              HasSubstr("--set kind: 2.5 must be a whole number"));
  EXPECT_THAT(run_brdf("eval --shader s.glsl --set kind=3 --set on=1 d.csv", folder.path()).out,
              HasSubstr(",-0.25"));
  EXPECT_THAT(run_brdf("models --shader s.glsl --json", folder.path()).out, HasSubstr("\"whole\": true"));
}

TEST(OwnShader, AFitHoldsTruthValuesAndLeavesOutPlacesWithoutAValue) {
  io::TemporaryFolder folder;
  std::ofstream(folder.path() / "s.glsl")
      << "//: param eta 1.2 2.4 1.6\n//: bool steep 1\n"
         "float brdf(vec3 L, vec3 V, vec3 N, float kd, float ks, float eta, bool steep) {\n"
         "  float c = dot(N, normalize(L + V));\n"
         "  return kd * 0.3 + ks * (steep ? pow(c, 9.0 * eta) : pow(c - 0.9, 0.5));\n}\n";
  const Outcome made = run_brdf(
      "synth --shader s.glsl --set kd=0.4 --set ks=0.7 --set eta=2 --grid in_plane -o t.csv", folder.path());
  ASSERT_EQ(made.exit_code, 0) << made.err;
  const Outcome fitted = run_brdf("fit t.csv --shader s.glsl --json", folder.path());
  EXPECT_THAT(fitted.err,
              AllOf(HasSubstr("the value is not finite at"), HasSubstr("steep is a whole number")));
  EXPECT_THAT(fitted.err, Not(HasSubstr("linear in none")));
}

TEST(OwnShader, TheDefaultsOfAColourAreListedByChannel) {
  io::TemporaryFolder folder;
  std::ofstream(folder.path() / "s.glsl")
      << "//: color base 0.5 0.4 0.3\nvec3 brdf(vec3 L, vec3 V, vec3 base, float k) { return base * k; }\n";
  EXPECT_THAT(run_brdf("models --shader s.glsl", folder.path()).out, HasSubstr("default 0.5,0.4,0.3"));
  const io::Json json =
      io::parse_json(run_brdf("models --shader s.glsl --json", folder.path()).out, "stdout");
  for (const io::Json& p : json["forms"][0]["parameters"])
    EXPECT_EQ(p["default"].is_array(), p["name"] == "base") << p;
}

TEST(OwnShader, LongNamesStayInTheirColumn) {
  io::TemporaryFolder folder;
  std::ofstream(folder.path() / "s.glsl")
      << "float brdf(vec3 L, vec3 V, float scatteringDistance, float k) { return scatteringDistance * k; }\n";
  const std::string out = run_brdf("models --shader s.glsl", folder.path()).out;
  const auto column = [&](const std::string& name) {
    const std::size_t line = out.find("  " + name + " ");
    return line == out.npos ? line : out.find("weight", line) - line;
  };
  ASSERT_NE(column("scatteringDistance"), out.npos) << out;
  EXPECT_EQ(column("scatteringDistance"), column("k")) << out;
}

}  // namespace
}  // namespace brdf
#endif
