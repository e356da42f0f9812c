#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/formats/read.h"
#include "io/samples/samples.h"
#include "tests/cli/run_brdf.h"

namespace brdf {
namespace {

using testing::HasSubstr;

class Microsurface : public testing::Test {
 protected:
  void SetUp() override {
    if (run("synth --microsurface gaussian" + kSmall + "-o probe.csv").exit_code == 3)
      GTEST_SKIP() << "this build has no ray tracer";
  }
  Outcome run(const std::string& arguments) { return run_brdf(arguments, folder_.path()); }
  std::string content(const std::string& name) {
    std::ifstream in(folder_.path() / name);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  const std::string kSmall = " --size 64 --surfaces 8 --rays 400 --cell 15 --theta-i 0,50 ";
  io::TemporaryFolder folder_;
};

TEST_F(Microsurface, SameCommandSameBytes) {
  const std::string command = "synth --microsurface gaussian --set alpha=0.4" + kSmall + "--seed 3 ";
  EXPECT_EQ(run(command + "-o a.csv").exit_code, 0);
  EXPECT_EQ(run(command + "-o b.csv").exit_code, 0);
  EXPECT_EQ(content("a.csv"), content("b.csv"));
  EXPECT_THAT(content("a.csv"), HasSubstr("# seed: 3\n"));
  EXPECT_THAT(content("a.csv"), HasSubstr("alpha_x=0.4"));
  EXPECT_GT(io::read_samples(folder_.path() / "a.csv").rows(), 20u);
}

TEST_F(Microsurface, RefusesWhatDoesNotApply) {
  for (const char* arguments : {"--microsurface gausian", "--microsurface gaussian --set sigma=0.3",
                                "--microsurface gaussian --noise 0.1", "--microsurface gaussian --form ward",
                                "--form ward --bounces 2", "--microsurface gaussian --surfaces 3"}) {
    const Outcome outcome = run(std::string("synth ") + arguments + " -o refused.csv");
    EXPECT_EQ(outcome.exit_code, 2) << arguments << outcome.err;
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "refused.csv")) << arguments;
  }
}

}  // namespace
}  // namespace brdf
