// Tests shaders that read textures in the verbs.
#ifdef BRDF_HAS_SHADER
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cli/run_brdf.h"
#include "texel/planes.h"

namespace brdf {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

constexpr const char* kTextured =
    "uniform sampler2D tint;\n//: param u 0 1 0.125\n//: param k 0 1 0.5\n"
    "float brdf(vec3 L, vec3 V, vec3 N, float u, float k) { return k * texture(tint, vec2(u, 0.5)).r / "
    "3.14159265; }\n";

class OwnTexture : public testing::Test {
 protected:
  OwnTexture() {
    std::ofstream(folder_.path() / "paint.glsl") << kTextured;
    texel::write_planes(folder_.path() / "tint.exr", {4, 1, {"R"}, {{0.25f, 0.5f, 0.75f, 1}}});
    std::ofstream(folder_.path() / "pair.csv") << "theta_i,phi_i,theta_o,phi_o\n30,0,40,0\n";
  }
  Outcome run(const std::string& words) { return run_brdf(words, folder_.path()); }

  io::TemporaryFolder folder_;
};

TEST_F(OwnTexture, IsReadByEveryVerbAndRecorded) {
  const std::string shader = " --shader paint.glsl --texture tint=tint.exr:nearest";
  const Outcome eval = run("eval" + shader + " --set k=1 --set u=0.6 pair.csv");
  EXPECT_EQ(eval.exit_code, 0) << eval.err;
  EXPECT_THAT(eval.out, AllOf(HasSubstr("--texture tint=tint.exr:nearest"), HasSubstr(",0.2387")));
  EXPECT_THAT(run("albedo" + shader + " --set k=1 --set u=0.6 --theta 30").out, HasSubstr("0.74999"));
  EXPECT_THAT(run("models" + shader).out, HasSubstr("paint"));
  const Outcome none = run("eval --shader paint.glsl pair.csv");
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_THAT(
      none.err,
      HasSubstr("paint.glsl:4: reads the texture tint: give its texels with --texture tint=FILE.exr"));
  EXPECT_THAT(run("eval --texture tint=tint.exr pair.csv").err, HasSubstr("--texture: needs --shader FILE"));
  EXPECT_THAT(run("render" + shader + " -o a.png").err, HasSubstr("cannot draw it"));
}

TEST_F(OwnTexture, IsJudgedAndItsCommandRepeatsIt) {
  // The last texel makes the albedo larger than 1.
  texel::write_planes(folder_.path() / "bright.exr", {2, 1, {"R"}, {{0.5f, 3}}});
  const Outcome o = run("validate --shader paint.glsl --texture tint=bright.exr");
  EXPECT_EQ(o.exit_code, 1);
  EXPECT_THAT(o.out, HasSubstr("$ brdf albedo --shader paint.glsl --texture tint=bright.exr --set k=1"));
  const Outcome good = run("validate --shader paint.glsl --texture tint=tint.exr --require energy,finite");
  EXPECT_EQ(good.exit_code, 0) << good.out;
  const Outcome all = run("check-shader paint.glsl --texture tint=tint.exr --texture other=tint.exr");
  EXPECT_EQ(all.exit_code, 0) << all.out;
}

// A read is enclosed by all texels: proofs hold for every coordinate.
TEST_F(OwnTexture, IsEnclosedByItsTexels) {
  const std::string prove = "prove --shader paint.glsl --property non_negative,energy --texture tint=";
  for (const std::string rules : {"", ":nearest:clamp", ":mirror"})
    EXPECT_EQ(run(prove + "tint.exr" + rules + " --require non_negative,energy").exit_code, 0) << rules;
  texel::write_planes(folder_.path() / "dark.exr", {2, 1, {"R"}, {{0.5f, -0.25f}}});
  const Outcome dark = run(prove + "dark.exr --require non_negative");
  EXPECT_EQ(dark.exit_code, 1);
  EXPECT_THAT(dark.out, HasSubstr("refuted"));
}

TEST_F(OwnTexture, IsKeptByTheMaterialOfAFit) {
  std::ofstream(folder_.path() / "paint.csv")
      << "theta_i,phi_i,theta_o,phi_o,fr\n0,0,10,0,0.1193662\n30,0,40,0,0.1193662\n60,0,20,90,0.1193662\n";
  const Outcome fit =
      run("fit paint.csv --shader paint.glsl --texture tint=tint.exr:nearest --fix u=0.6 -o m.json");
  EXPECT_EQ(fit.exit_code, 0) << fit.err;
  const Outcome eval = run("eval m.json pair.csv");
  EXPECT_EQ(eval.exit_code, 0) << eval.err;
  EXPECT_THAT(eval.out, HasSubstr(",0.1193"));
  texel::write_planes(folder_.path() / "tint.exr", {1, 1, {"R"}, {{0.25f}}});
  const Outcome changed = run("eval m.json pair.csv");
  EXPECT_EQ(changed.exit_code, 2);
  EXPECT_THAT(changed.err, AllOf(HasSubstr("m.json: $.shader.textures[0].sha256"), HasSubstr("has changed")));
  std::filesystem::remove(folder_.path() / "tint.exr");
  EXPECT_THAT(run("eval m.json pair.csv").err, HasSubstr("$.shader.textures[0].file"));
}

}  // namespace
}  // namespace brdf
#endif
