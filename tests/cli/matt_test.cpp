// Matt surfaces and retroreflectors through the executable: exit codes, and what is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "io/files/json.h"
#include "tests/cli/run_brdf.h"

namespace brdf {
namespace {

using testing::HasSubstr;
using testing::Not;

class Matt : public testing::Test {
 protected:
  Outcome run(const std::string& arguments) { return run_brdf(arguments, folder_.path()); }
  void write(const std::string& name, const std::string& text) {
    std::ofstream(folder_.path() / name) << text;
  }
  io::TemporaryFolder folder_;
};

const char* const kNegative =
    R"({"format":"brdf-material","version":1,"form":"matt_5","channels":["f"],)"
    R"("weights":{"w000":[0.3],"w020":[-0.45],"w220":[0.28],"w111":[-0.15],"w222":[0.25]}})";

TEST_F(Matt, ANegativeMaterialIsRefutedAndDrawnByNothing) {
  write("dark.json", kNegative);
  const Outcome proof = run("prove dark.json --property non_negative");
  EXPECT_EQ(proof.exit_code, 1);
  EXPECT_THAT(proof.out, HasSubstr("f is negative"));
  EXPECT_EQ(run("validate dark.json").exit_code, 1);
  for (const char* verb : {"synth --material dark.json -o samples.csv", "export dark.json --to mitsuba"}) {
    const Outcome refused = run(verb);
    EXPECT_EQ(refused.exit_code, 2) << verb;
    EXPECT_THAT(refused.err, HasSubstr("must not be below 0")) << verb;
  }
}

TEST_F(Matt, AFitOfASurfaceOfTheBasisIsProvedAtOnce) {
  ASSERT_EQ(
      run("synth --form matt_5 --set w000=0.9 --set w020=0.06 --set w220=0.1 --set w111=-0.2 --set w222=0.1 "
          "--grid hemisphere --step 15 --theta-i 5,25,45,65 --noise 0.005 -o tile.csv")
          .exit_code,
      0);
  const Outcome fit = run("fit tile.csv --form matt_5 -o tile.json");
  EXPECT_EQ(fit.exit_code, 0) << fit.err;
  EXPECT_THAT(fit.out, Not(HasSubstr("the weights were bounded")));
  const Outcome proof = run("prove tile.json --require non_negative,energy,reciprocity --json");
  EXPECT_EQ(proof.exit_code, 0) << proof.out;
  const Outcome albedo = run("albedo tile.json --theta 0,60 --json");
  const io::Json rows = io::Json::parse(albedo.out).at("results");
  const io::Json w = io::Json::parse(file_text(folder_.path() / "tile.json")).at("weights");
  const auto weight = [&](const char* name) {
    return w.at(name).is_array() ? w.at(name)[0].get<double>() : w.at(name).get<double>();
  };
  for (const io::Json& row : rows) {
    const double cosine = std::cos(row.at("theta").get<double>() * std::acos(-1.0) / 180),
                 r2 = 1 - 2 * cosine;
    const double line = weight("w000") + weight("w020") * (r2 - 1.0 / 3) / 2 - weight("w220") * r2 / 3;
    EXPECT_NEAR(row.at("value").get<double>(), line, 1e-12);
  }
}

TEST_F(Matt, HeldWeightsThatGiveANegativeValueEndWithExitCode1) {
  ASSERT_EQ(run("synth --form lambert --set rho=0.3 --noise 0.01 -o grey.csv").exit_code, 0);
  const Outcome fit = run("fit grey.csv --form matt_2 --fix w111=0.6 --bounds w000=0.2:0.4 -o grey.json");
  EXPECT_EQ(fit.exit_code, 1);
  EXPECT_THAT(fit.out, HasSubstr("f of matt_2 reaches -"));
  const Outcome nothing = run("fit grey.csv --form matt_2 --fix w111=0.6 --fix w000=0.7");
  EXPECT_EQ(nothing.exit_code, 2);
  EXPECT_THAT(nothing.err, HasSubstr("every parameter of matt_2 is held"));
}

TEST_F(Matt, AProgramWithoutALobeAboutTheLightIsNamed) {
  const Outcome refused = run("export --form retro --to gltf");
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.err, HasSubstr("--to gltf: retro is a lobe about the direction of the light"));
}

}  // namespace
}  // namespace brdf
