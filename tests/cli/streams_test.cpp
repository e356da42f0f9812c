// Tests materials as positional arguments, `-` as a stream, --quiet, and the next step after a result.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/files/json.h"
#include "tests/cli/run_brdf.h"

namespace brdf {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class Streams : public InFolder {
 protected:
  void SetUp() override {
    write("d.csv", "theta_i,phi_i,theta_o,phi_o\n30,180,30,0\n0,0,45,0\n");
    write("m.json", R"({"format": "brdf-material", "version": 1, "form": "ward", "channels": ["fr"],
      "weights": {"kd": [0.3], "ks": [0.2]}, "shape": {"alpha_x": 0.2, "alpha_y": 0.2}})");
    ASSERT_EQ(run("synth --form lambert --grid in_plane --theta-i 0,30 --step 5 -o s.csv").exit_code, 0);
  }
  // No test may leave a file of this name.
  void TearDown() override { EXPECT_FALSE(exists("-")); }

  // Returns the output without the lines that repeat the command or name its files.
  std::string results(const std::string& arguments) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << arguments << "\n" << outcome.err;
    std::istringstream lines(outcome.out);
    std::string rest;
    for (std::string line; std::getline(lines, line);)
      if (line.find("command") == line.npos && line.find("Written by") == line.npos &&
          !line.starts_with("# grid:"))
        rest += line + '\n';
    return rest;
  }
  void expect_refused(const std::string& arguments, const std::string& what) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << arguments;
    EXPECT_THAT(outcome.err, StartsWith("brdf: ")) << arguments;
    EXPECT_THAT(outcome.err, HasSubstr(what)) << arguments;
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    EXPECT_EQ(outcome.out, "") << arguments;
  }
};

TEST_F(Streams, AMaterialIsPositionalAndTheOlderOptionMeansTheSame) {
  EXPECT_EQ(results("eval m.json d.csv"), results("eval --material m.json d.csv"));
  EXPECT_EQ(results("albedo m.json --theta 0,60 --json"),
            results("albedo --material m.json --theta 0,60 --json"));
  EXPECT_EQ(results("export m.json --to glsl"), results("export --material m.json --to glsl"));
  EXPECT_EQ(results("synth m.json --grid d.csv -o -"), results("synth --material m.json --grid d.csv -o -"));
  EXPECT_EQ(results("export s.csv --to merl -o a.binary"),
            results("export --measured s.csv --to merl -o b.binary"));
  EXPECT_EQ(text("a.binary"), text("b.binary"));
}

TEST_F(Streams, AMaterialIsGivenOnce) {
  const std::string both = "MATERIAL m.json and --material m.json are both given: give one of them";
  expect_refused("eval m.json d.csv --material m.json", both);
  expect_refused("albedo m.json --material m.json --theta 0", both);
  expect_refused("export m.json --material m.json --to glsl", both);
  expect_refused("synth m.json --material m.json -o o.csv", both);
  expect_refused("recommend m.json --reference m.json --scene s.json",
                 "MATERIAL m.json and --reference m.json are both given");
  expect_refused("albedo m.json --form ward --theta 0", "exactly one of MATERIAL, --form and --shader");
  expect_refused("synth m.json --microsurface gaussian --set alpha=0.3 -o o.csv", "excludes");
}

TEST_F(Streams, AFileOfAnotherKindIsNamed) {
  for (const char* words : {"albedo s.csv --theta 0", "synth s.csv -o o.csv", "eval s.csv d.csv"})
    expect_refused(words,
                   "s.csv: is not a material, because a material is JSON; use `brdf fit` to make a material "
                   "from samples");
  expect_refused("eval d.csv m.json", "d.csv, m.json: the material's JSON comes first, then the directions");
  expect_refused("eval m.json", "exactly one of MATERIAL, --form and --shader");
  expect_refused("eval", "DIRECTIONS is required");
  expect_refused("export s.csv --to glsl", "samples have no formula");
  expect_refused("fit m.json", "is a material, not a table of samples");
}

TEST_F(Streams, AMinusIsStandardInput) {
  EXPECT_EQ(results("eval - d.csv <m.json"), results("eval m.json d.csv"));
  EXPECT_EQ(results("eval m.json - <d.csv"), results("eval m.json d.csv"));
  EXPECT_EQ(results("eval --form lambert - <d.csv"), results("eval --form lambert d.csv"));
  EXPECT_EQ(results("albedo --material - --theta 0 <m.json"), results("albedo m.json --theta 0"));
  EXPECT_EQ(results("export - --to glsl <m.json"), results("export --material /dev/stdin --to glsl <m.json"));
  EXPECT_EQ(results("synth m.json --grid - -o - <d.csv"), results("synth m.json --grid d.csv -o -"));
  const io::Json piped = io::parse_json(run("fit - --form lambert --json <s.csv").out, "piped"),
                 named = io::parse_json(run("fit s.csv --form lambert --json").out, "named");
  EXPECT_EQ(piped["ranking"], named["ranking"]);
  EXPECT_EQ(run("synth --form lambert --grid d.csv -o x.csv && cat s.csv | '" BRDF_EXECUTABLE
                "' convert - piped.csv && '" BRDF_EXECUTABLE "' convert s.csv named.csv")
                .exit_code,
            0);
  EXPECT_EQ(text("piped.csv").substr(text("piped.csv").find("theta_i")),
            text("named.csv").substr(text("named.csv").find("theta_i")));
  EXPECT_EQ(run("validate - <m.json").exit_code, 0);
  EXPECT_EQ(run("prove - --property non_negative <m.json").exit_code, 0);
}

TEST_F(Streams, MessagesNameStandardInputInWords) {
  expect_refused("fit - <m.json", "brdf: standard input: is a material, not a table of samples");
  expect_refused("albedo - --theta 0 <s.csv", "brdf: standard input: is not a material");
  expect_refused("eval m.json - <m.json", "brdf: standard input");
  EXPECT_THAT(run("convert - o.csv <s.csv").err, Not(HasSubstr("/dev/stdin")));
  for (const char* words : {"fit - --form lambert <s.csv", "fit - --form lambert --json <s.csv",
                            "validate - --json <s.csv", "validate - <m.json", "prove - --json <m.json"}) {
    const Outcome outcome = run(words);
    EXPECT_THAT(outcome.out + outcome.err, HasSubstr("standard input")) << words;
    EXPECT_THAT(outcome.out + outcome.err, Not(HasSubstr("/dev/stdin"))) << words;
  }
}

TEST_F(Streams, APageOfStandardInputHasCommandsThatReadAPipe) {
  EXPECT_EQ(run("study - --form lambert --no-pictures -o st <s.csv").exit_code, 0);
  const std::string page = text("st/index.html");
  EXPECT_THAT(page, HasSubstr("<h1>standard input</h1>"));
  EXPECT_THAT(page, HasSubstr("brdf validate -\n"));
  EXPECT_THAT(page, Not(HasSubstr("/dev/stdin")));
}

TEST_F(Streams, AFileCalledStandardInputIsNoStream) {
  std::filesystem::copy_file(folder_.path() / "s.csv", folder_.path() / "standard input");
  const Outcome outcome = run("fit 'standard input' --form lambert");
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.out, StartsWith("./standard input: "));
}

TEST_F(Streams, StandardInputIsReadOnce) {
  expect_refused("eval - - <m.json", "standard input can be read once, and MATERIAL reads it");
  expect_refused("fit - - -o fits <s.csv", "standard input can be read once");
  expect_refused("export - --measured - --to merl -o o.binary", "standard input can be read once");
}

TEST_F(Streams, AMinusIsStandardOutputForOneFileOfText) {
  const Outcome fit = run("fit s.csv --form lambert -o -");
  EXPECT_EQ(fit.exit_code, 0);
  EXPECT_THAT(fit.out, StartsWith("{"));
  EXPECT_EQ(io::parse_json(fit.out, "material")["form"], "lambert");
  EXPECT_THAT(fit.err, HasSubstr("lambert, converged")) << "the text for people";
  EXPECT_THAT(fit.err, Not(HasSubstr("brdf view"))) << "no file that could be shown";
  EXPECT_EQ(run("fit s.csv --form lambert -o m2.json").exit_code, 0);
  EXPECT_EQ(fit.out, text("m2.json"));
  EXPECT_THAT(run("fit s.csv --form lambert --report -").out, StartsWith("<!DOCTYPE html>"));
  EXPECT_THAT(run("validate m.json -o -").out, HasSubstr("| m.json | finite | pass |"));
  EXPECT_THAT(run("validate m.json -o -").err, HasSubstr("passed"));
  EXPECT_EQ(run("export m.json --to glsl -o -").out, run("export m.json --to glsl").out);
  EXPECT_EQ(results("eval m.json d.csv -o -"), results("eval m.json d.csv"));
  EXPECT_THAT(results("convert s.csv -"), HasSubstr("theta_i,phi_i,theta_o,phi_o"));
  const Outcome proof = run("prove m.json --property non_negative -o -");
  EXPECT_TRUE(io::parse_json(proof.out, "certificate").is_object());
  EXPECT_THAT(proof.err, HasSubstr("proved"));
  EXPECT_EQ(
      run("prove m.json --property non_negative -o - -q | '" BRDF_EXECUTABLE "' prove --check -").exit_code,
      0);
}

TEST_F(Streams, AMinusIsRefusedForFoldersPicturesAndTwoStreams) {
  for (const char* words :
       {"study s.csv -o -", "maps tiles -o -", "plan fit s.csv -o -", "render m.json -o -",
        "lobes m.json -o -", "recommend m.json --scene s.json -o -", "view --save-as -"})
    expect_refused(words, "'-' cannot be used: a folder or a picture cannot go to standard output");
  for (const char* words : {"plan fit - -o job", "render --scene - -o x.png", "view --state -",
                            "eval --shader - d.csv", "fit s.csv --regions -", "validate m.json --picture -"})
    expect_refused(words, "'-' cannot be used: this file cannot come from standard input");
  expect_refused("fit s.csv s.csv -o -", "-o -: the results of several files are a folder");
  expect_refused("synth m.json --texels 8x8 --lights 4 -o -", "-o -: a stack is a folder");
  expect_refused("export m.json --to merl -o -", "-o -: --to merl writes a binary table");
  expect_refused("export m.json --to glsl --json -o -", "--json: needs -o FILE");
  expect_refused("fit s.csv --json -o -", "-o -: --json writes to standard output too");
  expect_refused("fit s.csv -o - --report -", "--report -: -o writes to standard output too");
  expect_refused("validate m.json --json -o -", "-o -: --json writes to standard output too");
  expect_refused("prove m.json --json -o -", "-o -: --json writes to standard output too");
  expect_refused("trade --quick -o - --json", "-o -: --json writes to standard output too");
}

TEST_F(Streams, QuietLeavesResultsWarningsAndErrors) {
  EXPECT_EQ(run("synth --form lambert --grid d.csv -o q.csv -q").err, "");
  EXPECT_THAT(run("synth --form lambert --grid d.csv -o q.csv").err, HasSubstr("2 directions, 1 channel"));
  const Outcome fit = run("fit s.csv --form lambert --quiet -o m2.json");
  EXPECT_THAT(fit.out, HasSubstr("lambert, converged"));
  EXPECT_THAT(fit.out, Not(HasSubstr("look at it")));
  EXPECT_EQ(fit.err, "");
  EXPECT_EQ(run("fit s.csv --form lambert -q -o -").err, "") << "the result is the file";
  EXPECT_THAT(run("convert s.csv q.binary -q").err, StartsWith("brdf convert: lost: "));
  EXPECT_THAT(run("fit none.csv -q").err, HasSubstr("none.csv: cannot be read"));
  for (const char* verb : {"study", "fit", "validate", "models", "eval", "synth", "convert", "plan", "work",
                           "collect", "prove", "albedo", "export"})
    EXPECT_THAT(run(std::string(verb) + " --help").out, HasSubstr("-q,--quiet")) << verb;
}

TEST_F(Streams, AResultEndsWithTheCommandThatShowsIt) {
  EXPECT_THAT(run("fit s.csv --form lambert -o 'a b.json'").out,
              testing::EndsWith("\nlook at it: brdf view 'a b.json' --measured s.csv\n"));
  EXPECT_THAT(
      run("fit s.csv --form lambert -o c.json --report c.html").out,
      testing::EndsWith("\nlook at it: brdf view c.json --measured s.csv, or open c.html in a browser\n"));
  EXPECT_THAT(run("fit - --form lambert -o c.json <s.csv").out,
              testing::EndsWith("\nlook at it: brdf view c.json\n"));
  EXPECT_THAT(run("fit s.csv --form lambert --quantity f_r -o c.json").out,
              testing::EndsWith("\nlook at it: brdf view c.json\n"))
      << "the window has no --quantity";
  EXPECT_THAT(run("fit s.csv --form lambert").out, Not(HasSubstr("look at it")));
  EXPECT_THAT(run("fit s.csv --form lambert --json -o c.json").out, Not(HasSubstr("look at it")));
  EXPECT_THAT(
      run("study s.csv --form lambert --no-pictures -o st").out,
      testing::EndsWith("\nlook at it: open st/index.html in a browser, or brdf view st/material.json "
                        "--measured s.csv\n"));
  EXPECT_THAT(run("validate m.json -o r.html").out,
              testing::EndsWith("\nlook at it: open r.html in a browser\n"));
  EXPECT_THAT(run("prove m.json --property non_negative -o p.json").out,
              testing::EndsWith("\ncheck it: brdf prove --check p.json\n"));
  EXPECT_THAT(run("export m.json --to rgl -o m.bsdf").err,
              testing::EndsWith("\nlook at it: brdf view m.bsdf\n"));
  EXPECT_THAT(run("synth m.json -o o.csv").err, testing::EndsWith("\nlook at it: brdf view o.csv\n"));
  EXPECT_THAT(run("convert o.csv o.exr").err, testing::EndsWith("\nlook at it: brdf view o.exr\n"));
}

}  // namespace
}  // namespace brdf
