// Names of files and cells must reach a terminal as text that cannot control it. The remains of an
// interrupted run are reported in one line.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/files/json.h"
#include "tests/cli/run_brdf.h"

namespace brdf {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const std::string kTable =
    "theta_i,phi_i,theta_o,phi_o,f\n0,180,10,0,.1\n30,180,10,0,.2\n30,180,30,0,.3\n60,180,50,0,.1\n60,180,60,"
    "0,.15\n"
    "45,180,45,0,.12\n";
// An escape, a line feed, and marks that reverse the direction of text.
const std::string kRed = "a\x1b[31mred.csv", kLines = "b\n[1 of 1] all is well \xe2\x80\xaevsc.csv",
                  kMarks = "c\xe2\x81\xa6\xd8\x9c\xe2\x80\x8f\xc2\x9b.csv";

// Returns a part of the text that no output may contain, or an empty string.
std::string raw_part(const std::string& text) {
  for (const char* part : {"\x1b", "\r", "\xe2\x80\xae", "\xe2\x81\xa6", "\xd8\x9c", "\xe2\x80\x8f",
                           "\xc2\x9b", "\n[1 of 1] all"})
    if (text.find(part) != text.npos) return part;
  return "";
}

class ShownText : public testing::Test {
 protected:
  void write(const fs::path& name, const std::string& content) {
    fs::create_directories((folder_.path() / name).parent_path());
    std::ofstream(folder_.path() / name, std::ios::binary) << content;
  }
  Outcome run(const std::string& arguments) { return run_brdf(arguments, folder_.path()); }
  // Runs a command that must exit with code `most` or less, and checks both of its outputs.
  void expect_safe(const std::string& arguments, int most) {
    const Outcome outcome = run(arguments);
    EXPECT_LE(outcome.exit_code, most) << arguments << outcome.err;
    EXPECT_EQ(raw_part(outcome.out), "") << arguments << outcome.out;
    EXPECT_EQ(raw_part(outcome.err), "") << arguments << outcome.err;
  }
  io::TemporaryFolder folder_;
};

TEST_F(ShownText, OfEveryVerbHoldsNoRawByteOfAFilesName) {
  for (const std::string& name : {kRed, kLines, kMarks}) {
    write(name, kTable);
    const std::string file = "'" + name + "'", material = "'m" + name + ".json'";
    expect_safe("convert " + file + " 'o" + name + "'", 0);
    expect_safe("validate " + file, 1);
    expect_safe("validate --json " + file, 1);
    expect_safe("fit " + file + " --form lambert -o " + material, 1);
    expect_safe("fit " + file + " --form lambert --json", 1);
    expect_safe("study " + file + " --form lambert --no-pictures -o 's" + name + "'", 1);
    expect_safe("study " + file + " --form lambert --no-pictures --json -o 's" + name + "'", 1);
    expect_safe("synth --form lambert --grid " + file + " -o 'y" + name + "'", 0);
    expect_safe("albedo --theta 30 --material " + material, 0);
    expect_safe("validate " + material, 1);
    expect_safe("prove " + material, 1);
    expect_safe("export --to merl --measured " + file + " -o 'x" + name + "'", 0);
    expect_safe("export --to blender --material " + material + " -o 'p" + name + ".py'", 1);
    expect_safe("fit 'no such " + name + "'", 2);
    expect_safe("fit " + file + " --form '" + name + "'", 2);
    expect_safe("fit " + file + " --quantity '" + name + "'", 2);
    expect_safe("'" + name + "'", 2);
    expect_safe("--" + name.substr(0, 1) + "'" + name + "'", 2);
  }
  EXPECT_THAT(run("validate '" + kRed + "'").out, HasSubstr("a\\x1b[31mred.csv\n"));
  EXPECT_THAT(run("validate '" + kLines + "'").out, HasSubstr("b\\x0a[1 of 1] all is well \\u202evsc.csv\n"));
  EXPECT_THAT(run("validate '" + kMarks + "'").out, HasSubstr("c\\u2066\\u061c\\u200f\\xc2\\x9b.csv\n"));
}

TEST_F(ShownText, OfFoldersHoldsNoRawByteOfTheirFilesNames) {
  for (const std::string& name : {kRed, kLines, kMarks}) write("in/" + name, kTable);
  write("in/bad" + kRed,
        "theta_i,phi_i,theta_o,phi_o,f\n1,2,3,4,a\xe2\x80\xae"
        "b\x1b[31m\n");
  expect_safe("fit in --form lambert --no-pictures -o 'out" + kRed + "'", 1);
  expect_safe("study in --form lambert --no-pictures -o 'st" + kLines + "'", 1);
  expect_safe("plan fit in -o 'job" + kRed + "'", 0);
  const Outcome fits = run("fit in --form lambert --no-pictures -o out");
  EXPECT_THAT(fits.err, AllOf(HasSubstr("in/a\\x1b[31mred.csv: lambert"),
                              HasSubstr("(f): 'a\\u202eb\\x1b[31m' is not a number")));
}

// Tests cells, names of columns, comments and texts of JSON.
TEST_F(ShownText, OfContentHoldsNoRawByte) {
  const std::string mark = "\xe2\x80\xae", names = "theta_i,phi_i,theta_o,phi_o,";
  write("cell.csv", names + "f\n1,2,3,4,a" + mark + "b\n");
  write("channel.csv", names + "f" + mark + "\n1,2,3,4,5\n");
  write("aside.csv", names + "remark x" + mark + ",BRDF\n1,2,3,4,5,.2\n");
  write("quantity.csv", "# quantity: x" + mark + "\n" + names + "f\n1,2,3,4,5\n");
  write("titled.csv", "BRF" + mark + "\x1b[31m\n" + names + "f\n30,180,30,0,.5\n");
  write("material.json", "{\"format\": \"brdf-material\", \"version\": 1, \"form\": \"x" + mark + "\"}");
  for (const char* file :
       {"cell.csv", "channel.csv", "aside.csv", "quantity.csv", "titled.csv", "material.json"})
    for (const char* verb : {"convert ", "validate ", "fit --form lambert "})
      expect_safe(std::string(verb) + file + (*verb == 'c' ? " out.csv" : ""), 2);
  EXPECT_THAT(run("convert cell.csv o.csv").err, HasSubstr("'a\\u202eb' is not a number"));
  EXPECT_THAT(run("convert channel.csv o.csv").err,
              HasSubstr("channel 'f\\u202e' must not contain control characters or direction marks"));
  EXPECT_THAT(run("convert aside.csv o.csv").err, HasSubstr("column 'remark x\\u202e' is ignored"));
}

TEST_F(ShownText, OfJsonIsEscapedAsJson) {
  write(kMarks, kTable);
  const Outcome outcome = run("fit '" + kMarks + "' --form lambert --json");
  EXPECT_THAT(outcome.out, HasSubstr("c\\u2066\\u061c\\u200f\\u009b.csv"));
  EXPECT_EQ(io::parse_json(outcome.out, "stdout")["samples"]["file"], kMarks);
}

TEST_F(ShownText, OfAnInterruptedRunNamesTheRestInOneLine) {
  constexpr int kSamples = 2000;
  for (int k = 0; k < kSamples; ++k) write("in/s" + std::to_string(k) + ".csv", kTable);
  for (const std::string verb : {"study", "fit"}) {
    const Outcome outcome =
        run_interrupted(verb + " in --form ward --no-pictures -o " + verb + ".out", folder_.path());
    const auto& [exit_code, out, err] = outcome;
    EXPECT_NE(exit_code, 0);
    const std::string line = "brdf " + verb + ": interrupted: ";
    ASSERT_THAT(err,
                AllOf(HasSubstr(line), HasSubstr(" of " + std::to_string(kSamples) + " not processed\n")));
    EXPECT_EQ(err.find("interrupted", err.find(line) + line.size()), err.npos) << err;
    EXPECT_EQ(err.find("interrupted"), err.find(line) + 6 + verb.size() + 1) << err;
    EXPECT_THAT(out, Not(HasSubstr(" error: ")));
  }
}

}  // namespace
}  // namespace brdf
