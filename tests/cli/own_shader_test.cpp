// A user's shader through the verbs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/cli/run_brdf.h"

namespace brdf {
namespace {

using testing::HasSubstr;

const std::string kShaders = "'" BRDF_SOURCE_DIR "/data/shaders/";

nlohmann::json finding(const std::string& out, const std::string& check) {
  const nlohmann::json all = nlohmann::json::parse(out);
  for (const auto& f : all["findings"])
    if (f["check"] == check) return f;
  return nullptr;
}

TEST(OwnShader, ASoundOnePasses) {
  TemporaryFolder folder;
  const Outcome o = run_brdf("validate --shader " + kShaders +
                                 "sound.glsl' --such-that 'kd + ks <= 1' --require "
                                 "finite,non_negative,reciprocity,energy,isotropy,float --json",
                             folder.path());
  EXPECT_EQ(o.exit_code, 0) << o.out << o.err;
  // A grey diffuse reflector sends everything back.
  EXPECT_NEAR(finding(o.out, "energy")["value"].get<double>(), 1, 1e-3);
  // Without the condition kd and ks may both be 1.
  const Outcome free = run_brdf("validate --shader " + kShaders + "sound.glsl' --json", folder.path());
  EXPECT_EQ(free.exit_code, 1);
  EXPECT_GT(finding(free.out, "energy")["value"].get<double>(), 1.5);
}

TEST(OwnShader, AClampedProductIsFoundWithTheCommandThatShowsIt) {
  TemporaryFolder folder;
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
  TemporaryFolder folder;
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
              testing::AllOf(HasSubstr("not finite in float, where double is"), HasSubstr("line 3"),
                             HasSubstr("/ 0 = inf")));
}

TEST(OwnShader, IsRefusedWithOneSentence) {
  TemporaryFolder folder;
  std::ofstream(folder.path() / "main.frag")
      << "#version 330 core\nout vec4 c;\nvoid main() { c = vec4(1.0); }\n";
  std::ofstream(folder.path() / "loop.glsl")
      << "float brdf(vec3 L, vec3 V) {\n  float s = 0.0;\n  while (s >= 0.0) s += 1.0;\n  return s;\n}\n";
  for (const auto& [file, sentence] : {std::pair("main.frag", "//: entry NAME"),
                                       std::pair("loop.glsl", "loop.glsl:3: the loop here does not end")}) {
    const Outcome o = run_brdf(std::string("validate --shader ") + file, folder.path());
    EXPECT_EQ(o.exit_code, 2) << file;
    EXPECT_THAT(o.err, HasSubstr(sentence));
  }
  EXPECT_EQ(run_brdf("albedo --form ward --param a=0:1 --theta 0", folder.path()).exit_code, 2);
}

TEST(OwnShader, ThatTurnsWithItsTangentIsJudged) {
  TemporaryFolder folder;
  std::ofstream(folder.path() / "s.glsl") << "//: violates energy\nfloat brdf(vec3 L, vec3 V, vec3 N, vec3 "
                                             "X) { return 0.3 * (1.0 + dot(L, X) * dot(V, X)); }\n";
  const Outcome o = run_brdf("validate --shader s.glsl --json", folder.path());
  EXPECT_EQ(o.exit_code, 1) << o.err;
  EXPECT_EQ(finding(o.out, "reciprocity")["verdict"], "pass");
  // Declared and not there: 0.3 pi.
  EXPECT_EQ(finding(o.out, "energy")["verdict"], "fail");
  EXPECT_NEAR(finding(o.out, "energy")["value"].get<double>(), 0.3 * 3.14159265, 1e-3);
}

TEST(OwnShader, IsDrawnAsItIsEvaluated) {
  TemporaryFolder folder;
  std::ofstream(folder.path() / "many.glsl")
      << "float brdf(vec3 L, vec3 V, vec3 N, float a, float b, float c, float d, int n) {\n  float t[3] = "
         "float[3](0.1, 0.2, 0.3), s = 0.0;\n  for (int k = 0; k < n + 2; ++k) { if (k == 1 && d > 0.2) "
         "continue; s "
         "+= t[k % 3] * a * b; }\n  return s * (1.0 + pow(c, 2.0) * d * L.z * V.z);\n}\n";
  {
    const Outcome o = run_brdf("render --parity --shader many.glsl", folder.path());
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

TEST(OwnShader, IsComparedWithAForm) {
  TemporaryFolder folder;
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
  TemporaryFolder folder;
  const std::string shader = "--shader " + kShaders + "wrong_norm.brdf'";
  ASSERT_EQ(run_brdf("synth " + shader +
                         " --set kd=0.2 --set ks=0.6 --set exponent=37 --grid in_plane --noise 0 -o s.csv",
                     folder.path())
                .exit_code,
            0);
  const Outcome o = run_brdf("fit s.csv " + shader + " --json", folder.path());
  EXPECT_EQ(o.exit_code, 0) << o.err;
  const auto material = nlohmann::json::parse(o.out)["ranking"][0]["material"];
  EXPECT_NEAR(material["weights"]["kd"][0].get<double>(), 0.2, 1e-6);
  EXPECT_NEAR(material["weights"]["ks"][0].get<double>(), 0.6, 1e-6);
  EXPECT_NEAR(material["shape"]["exponent"].get<double>(), 37, 1e-4);
}

}  // namespace
}  // namespace brdf
