// Tests that every verb reads all inputs that a shell can pass, and refuses an unreadable input in one
// line.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/formats/read.h"
#include "io/material/material_file.h"
#include "io/samples/samples.h"
#include "tests/cli/run_brdf.h"

namespace brdf {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class ReadingCli : public testing::Test {
 protected:
  void SetUp() override {
    write("s.csv",
          "theta_i,phi_i,theta_o,phi_o,f\n0,180,10,0,.1\n30,180,10,0,.2\n30,180,30,0,.3\n60,180,50,0,.1\n"
          "60,180,60,0,.15\n45,180,45,0,.12\n");
    write(
        "m.json",
        R"({"format": "brdf-material", "version": 1, "form": "lambert", "channels": ["f"], "weights": {"rho": 0.5}})");
    write("d.csv", "theta_i,phi_i,theta_o,phi_o\n30,180,30,0\n");
  }
  void write(const std::string& name, const std::string& content) {
    std::ofstream(folder_.path() / name, std::ios::binary) << content;
  }
  std::string text(const std::string& name) { return file_text(folder_.path() / name); }
  Outcome run(const std::string& arguments) { return run_brdf(arguments, folder_.path()); }
  // Creates a named pipe into which a separate process writes the file.
  void pipe(const std::string& name, const std::string& file) {
    const std::string command = "cd '" + folder_.path().string() + "' && mkfifo " + name +
                                " && (timeout 60 sh -c 'cat " + file + " > " + name + "' &)";
    ASSERT_EQ(std::system(command.c_str()), 0);
  }
  void expect_refused(const std::string& arguments, const std::string& what) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << arguments;
    EXPECT_THAT(outcome.err, HasSubstr(what)) << arguments;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << arguments << outcome.err;
  }
  io::TemporaryFolder folder_;
};

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t k = 0; (k = text.find(from, k)) != text.npos; k += to.size())
    text.replace(k, from.size(), to);
  return text;
}

TEST_F(ReadingCli, EveryVerbReadsAPipeAsItReadsAFile) {
  const std::pair<std::string, std::string> commands[] = {
      {"fit FILE --form lambert", "s.csv"},
      {"validate FILE", "s.csv"},
      {"convert FILE o.csv", "s.csv"},
      {"eval --form lambert FILE", "d.csv"},
      {"synth --form lambert --grid FILE -o o.csv", "d.csv"},
      {"eval --material FILE d.csv", "m.json"},
      {"albedo --material FILE --theta 30", "m.json"},
      {"export --material FILE --to glsl", "m.json"},
      {"synth --material FILE --grid d.csv -o o.csv", "m.json"},
      {"validate FILE", "m.json"},
  };
  int number = 0;
  for (const auto& [command, file] : commands) {
    const std::string name = "pipe" + std::to_string(++number);
    const Outcome expected = run(replaced(command, "FILE", file));
    EXPECT_LE(expected.exit_code, 1) << command << expected.err;
    pipe(name, file);
    const Outcome piped = run(replaced(command, "FILE", name));
    EXPECT_EQ(piped.exit_code, expected.exit_code) << command << piped.err;
    EXPECT_EQ(replaced(piped.out, name, file), expected.out) << command;
    EXPECT_EQ(replaced(piped.err, name, file), expected.err) << command;
  }
}

TEST_F(ReadingCli, ABatchReadsPipes) {
  pipe("a.pipe", "s.csv");
  pipe("b.pipe", "s.csv");
  const Outcome outcome = run("fit a.pipe b.pipe --form lambert --no-pictures -o out");
  EXPECT_LE(outcome.exit_code, 1) << outcome.err;
  const Material a = io::read_material(folder_.path() / "out/a.json");
  EXPECT_EQ(a, io::read_material(folder_.path() / "out/b.json"));
  EXPECT_GT(a.terms[0].weights[0][0], 0.1);
}

TEST_F(ReadingCli, ADeviceThatNeverEndsIsRefusedByEveryVerb) {
  for (const char* command :
       {"fit /dev/zero", "fit /dev/zero s.csv -o out --form lambert", "validate /dev/zero",
        "convert /dev/zero o.csv", "eval --form lambert /dev/zero", "eval --material /dev/zero d.csv",
        "albedo --material /dev/zero --theta 0", "synth --form lambert --grid /dev/zero -o o.csv",
        "export --material /dev/zero --to glsl"}) {
    const Outcome outcome = run(command);
    EXPECT_NE(outcome.exit_code, 0) << command;
    EXPECT_THAT(outcome.out + outcome.err, HasSubstr("/dev/zero: is a device")) << command;
  }
}

TEST_F(ReadingCli, ConvertingTwiceGivesTheSameFile) {
  write("c.csv", "# : quantity: f_r*cos_o\ntheta_i,phi_i,theta_o,phi_o,f\n30,180,60,0,1\n");
  write("a.txt", "quantity f_r*cos_o\nVARS theta_i,phi_i,theta_s,phi_s,Y\n30,180,60,0,1\n");
  for (const char* name : {"c.csv", "a.txt"}) {
    EXPECT_EQ(run(std::string("convert ") + name + " one.csv").exit_code, 0);
    EXPECT_EQ(run("convert one.csv two.csv").exit_code, 0);
    EXPECT_EQ(text("one.csv"), text("two.csv")) << name;
    EXPECT_THAT(text("two.csv"), AllOf(HasSubstr("# quantity: f_r\n"), HasSubstr("30,180,60,0,1\n"))) << name;
  }
}

TEST_F(ReadingCli, ValuesTimesTheCosineSaySo) {
  write("v.csv", "theta_i,phi_i,theta_o,phi_o,g,sigma_g\n60,180,30,0,2,.2\n");
  EXPECT_EQ(run("eval --form lambert --set rho=1 --cos v.csv -o o.csv").exit_code, 0);
  EXPECT_THAT(text("o.csv"), HasSubstr("# quantity: f_r*cos_i\n"));
  const io::SampleTable back = io::read_samples(folder_.path() / "o.csv");
  EXPECT_DOUBLE_EQ(back.values[0][0], 2);
  EXPECT_DOUBLE_EQ(back.sigma[0][0], .2);
  EXPECT_DOUBLE_EQ(back.values[1][0], 1 / kPi);
}

TEST_F(ReadingCli, HostileTextIsRefusedInOneLineThatATerminalCanShow) {
  write("deep.json", std::string(100000, '[') + std::string(100000, ']'));
  write("large.json", "{\"format\": \"brdf-material\", \"version\": 1e400}");
  write("escape.csv", "theta_i,phi_i,theta_o,phi_o,\x1b[31mred\n1,2,3,4,5\n");
  std::string merl(1012, '\0');
  merl[0] = merl[4] = 90;
  merl[8] = char(180);
  write("merl.binary", merl);
  for (const char* verb :
       {"eval d.csv --material ", "albedo --theta 0 --material ", "export --to glsl --material "}) {
    expect_refused(std::string(verb) + "deep.json", "is nested more than 100 levels deep");
    expect_refused(std::string(verb) + "large.json",
                   "large.json: $.version: '1e400' exceeds the range of numbers");
  }
  expect_refused("fit m.json", "m.json: is a material, not a table of samples");
  write("p.png", "\x89PNG\r\n");
  expect_refused("validate p.png", "p.png: is a picture (PNG), not a table of samples");
  write("f.json", "{\"ranking\": []}");
  expect_refused(
      "validate f.json",
      "f.json: is the result of a fit (fit --json), not a material; use the file written by fit -o");
  expect_refused("fit escape.csv", "channel '\\x1b[31mred' must not contain control characters");
  expect_refused("fit merl.binary", "merl.binary: the MERL file has 1012 bytes, but");
  const Outcome outcome = run("fit '\x1b[31m.csv'");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("\\x1b[31m.csv: cannot be read"), Not(HasSubstr("\x1b"))));
}

TEST_F(ReadingCli, GridsBeyondTheLimitAreRefusedBeforeTheyAreMade) {
  expect_refused("synth --form lambert --step 0.01 -o o.csv", "directions, more than 4000000");
  expect_refused("synth --form lambert --step 0.2 --azimuths 0,45,90 -o o.csv",
                 "directions, more than 4000000");
}

TEST_F(ReadingCli, SettingsForMoreChannelsThanAMaterialHasAreRefused) {
  std::string values = "0.5";
  for (int k = 0; k < 4096; ++k) values += ",0.5";
  expect_refused("albedo --form lambert --theta 0 --set rho=" + values,
                 "--set: 4097 values exceed the limit of 4096");
}

// The name of a channel and of the file is in Latin-1. The results of the fit must be written nevertheless.
TEST_F(ReadingCli, NamesThatAreNotUtf8DoNotCostTheWork) {
  write("gr\xfcn.csv", replaced(text("s.csv"), "phi_o,f", "phi_o,gr\xfcn"));
  const Outcome outcome = run("fit 'gr\xfcn.csv' --form lambert --json -o o.json --report o.html");
  EXPECT_LE(outcome.exit_code, 1) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("gr\xc3\xbcn"));
  EXPECT_THAT(text("o.json"), HasSubstr("gr\xc3\xbcn"));
  EXPECT_NE(run("validate 'gr\xfcn.csv' --json -o v.html").exit_code, 3);
  EXPECT_TRUE(std::filesystem::exists(folder_.path() / "v.html"));
}

}  // namespace
}  // namespace brdf
