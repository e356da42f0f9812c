// Tests text for terminals: folded to their width, with the remaining time, and with suggestions for
// misspelt names.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "cli/options/progress.h"
#include "cli/options/terminal.h"
#include "tests/cli/run_brdf.h"

namespace brdf::cli {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

std::size_t longest_line(const std::string& text) {
  std::istringstream lines(text);
  std::size_t longest = 0;
  for (std::string line; std::getline(lines, line);) longest = std::max(longest, line.size());
  return longest;
}

TEST(Folded, BreaksAtBlanksAndGoesOnUnderTheLastCell) {
  EXPECT_EQ(folded("one two three", 0), "one two three");
  EXPECT_EQ(folded("  one two three", 10), "  one two\n    three");
  EXPECT_EQ(folded("ab  one two three\n", 12), "ab  one two\n    three\n");
  EXPECT_EQ(folded("a line\n\nanother\n", 60), "a line\n\nanother\n");
}

TEST(Folded, LeavesLongWordsWholeAndBreaksListsAtCommas) {
  EXPECT_EQ(folded("a wordthatislongerthantheline b", 10), "a\n  wordthatislongerthantheline\n  b");
  EXPECT_EQ(folded("{one,two,three}", 10), "{one,two,\n  three}");
}

TEST(Folded, ColoursAndLettersBeyondAsciiHaveTheirWidthOnScreen) {
  const std::string red = "\x1b[31mred\x1b[0m";
  EXPECT_EQ(folded(red + " and more", 12), red + " and more");
  EXPECT_EQ(folded("\xc3\xa4\xc3\xb6\xc3\xbc \xc3\xa4\xc3\xb6\xc3\xbc", 7),
            "\xc3\xa4\xc3\xb6\xc3\xbc \xc3\xa4\xc3\xb6\xc3\xbc");
}

TEST(ProgressText, ShowsABarAndTheTimeLeftFromTwoSecondsOn) {
  EXPECT_EQ(progress_text("3 of 16", 3.0 / 16, 1.9, 80), "3 of 16");
  EXPECT_EQ(progress_text("5 of 10", 0.5, 8, 80), "[##########..........] 8 s left  5 of 10");
  EXPECT_EQ(progress_text("1 of 10", 0.1, 20, 80), "[##..................] 3 min 0 s left  1 of 10");
  EXPECT_EQ(progress_text("begun", 0, 20, 80), "begun") << "nothing is known yet";
  EXPECT_EQ(progress_text(std::string(100, 'x'), 0.5, 8, 60).size(), 59u);
}

class Terminal : public testing::Test {
 protected:
  // Runs the command as on a terminal of this many columns.
  Outcome run(const std::string& arguments, int columns = 0) const {
    const Setting width("COLUMNS", columns ? std::to_string(columns).c_str() : nullptr);
    return run_brdf(arguments, folder_.path());
  }
  std::string says(const std::string& arguments) const { return run(arguments).err; }

 private:
  io::TemporaryFolder folder_;
};

TEST_F(Terminal, HelpIsNoWiderThanTheTerminal) {
  for (const int columns : {60, 80, 200}) {
    EXPECT_LE(longest_line(run("--help", columns).out), std::size_t(columns));
    for (const char* verb :
         {"models", "eval", "albedo", "synth", "fit", "validate", "convert", "study", "export"})
      EXPECT_LE(longest_line(run(std::string(verb) + " --help", columns).out), std::size_t(columns)) << verb;
  }
}

TEST_F(Terminal, HelpComesWithoutAVerbTooAndGroupsThem) {
  const Outcome alone = run("");
  EXPECT_EQ(alone.exit_code, 0);
  EXPECT_EQ(alone.out, run("--help").out);
  std::size_t last = 0;
  for (const char* heading : {"\nBegin here:\n", "\nLook:\n", "\nMeasure:\n", "\nJudge:\n", "\nShip:\n"}) {
    const std::size_t at = alone.out.find(heading);
    ASSERT_NE(at, alone.out.npos) << heading;
    EXPECT_GT(at, last);
    last = at;
  }
  EXPECT_THAT(alone.out, HasSubstr("      brdf fit samples.csv --form all -o material.json\n"));
}

TEST_F(Terminal, HelpAndVersionAreVerbsToo) {
  EXPECT_EQ(run("help").out, run("--help").out);
  EXPECT_EQ(run("help fit").out, run("fit --help").out);
  EXPECT_EQ(run("version").out, run("--version").out);
  EXPECT_EQ(says("help fitt"), says("fitt"));
  EXPECT_EQ(run("help fit render").exit_code, 2);
}

TEST_F(Terminal, RankingLeavesOutColumnsThatHaveNoRoom) {
  ASSERT_EQ(run("synth --form lambert -o s.csv").exit_code, 0);
  const std::string command = "fit s.csv --form all";
  const std::string narrow = run(command, 60).out, wide = run(command, 200).out;
  EXPECT_THAT(narrow, HasSubstr("  verdict           median    x scatter\n"));
  EXPECT_LE(longest_line(narrow), 60u);
  EXPECT_THAT(wide, HasSubstr("  x scatter  parameters\n"));
  EXPECT_THAT(narrow, Not(HasSubstr("\x1b["))) << "no terminal, no colours";
}

TEST_F(Terminal, NamesThatWereMeantAreSuggested) {
  EXPECT_EQ(says("fitt"), "brdf: 'fitt' is not a verb (did you mean fit? see brdf --help)\n");
  EXPECT_EQ(says("fit --fom"),
            "brdf: --fom is not an option of brdf fit (did you mean --form? see brdf fit --help)\n");
  EXPECT_THAT(
      says("models blin"),
      StartsWith("brdf: 'blin' is not the name of a form (did you mean blinn_phong? known: lambert, "));
  EXPECT_THAT(says("models ggx"), HasSubstr("did you mean cook_torrance? "));
  EXPECT_THAT(says("models Beckmann"), HasSubstr("did you mean cook_torrance_beckmann? "));
  EXPECT_THAT(says("models qqqqqq"), HasSubstr("'qqqqqq' is not the name of a form (known: lambert"));
  ASSERT_EQ(run("synth --form lambert -o copper.csv").exit_code, 0);
  EXPECT_THAT(says("eval --form phong --set exponnt=1 copper.csv"),
              HasSubstr("(did you mean exponent? known: kd, ks, "));
  EXPECT_THAT(says("eval --form ward --set specular=1 copper.csv"),
              HasSubstr("(did you mean ks? known: kd, ks, "));
  EXPECT_THAT(says("fit coper.csv"), HasSubstr("No such file or directory; did you mean copper.csv?"));
}

TEST_F(Terminal, SamplesAndMaterialsAreToldApart) {
  ASSERT_EQ(run("synth --form lambert -o copper.csv").exit_code, 0);
  ASSERT_EQ(run("fit copper.csv --form lambert -o copper.json").exit_code, 0);
  EXPECT_THAT(says("albedo --theta 0 --material copper.csv"),
              HasSubstr("is not a material, because a material is JSON; use `brdf fit` to make"));
  EXPECT_THAT(says("fit copper.json"),
              HasSubstr("is a material, not a table of samples; use `brdf synth` to compute"));
}

}  // namespace
}  // namespace brdf::cli
