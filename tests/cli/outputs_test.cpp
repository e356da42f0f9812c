// Tests that the verbs check their outputs before they start, and report outputs that could not be written.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/files/json.h"
#include "tests/cli/run_brdf.h"

namespace brdf {
namespace {

using testing::HasSubstr;
using testing::Not;

class Outputs : public InFolder {
 protected:
  void SetUp() override {
    write("d.csv", "theta_i,phi_i,theta_o,phi_o\n30,180,30,0\n0,0,45,0\n");
    write("m.json", R"({"format": "brdf-material", "version": 1, "form": "ward", "channels": ["fr"],
      "weights": {"kd": [0.9], "ks": [0.9]}, "shape": {"alpha_x": 0.1, "alpha_y": 0.1}})");
    ASSERT_EQ(run("synth --form lambert --grid in_plane --theta-i 0,30 --step 15 -o s.csv").exit_code, 0);
  }
  // Returns the exit code of the program, followed by its stderr, as a shell receives them.
  std::string seen(const std::string& arguments) { return run(arguments + " 2>e; echo $? $(cat e)").out; }
  void expect_refused(const std::string& arguments, const std::string& what) {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << arguments;
    EXPECT_THAT(outcome.err, HasSubstr(what)) << arguments;
    EXPECT_EQ(outcome.out, "") << arguments;
  }
};

TEST_F(Outputs, LostStandardOutputIsTheEnvironmentsFault) {
  for (const char* words : {"models", "models --json", "--help", "--version", "eval --form lambert d.csv",
                            "albedo --form lambert --theta 30", "export --form ward --to glsl",
                            "fit s.csv --form lambert", "validate s.csv --json", "render --help"}) {
    EXPECT_THAT(seen(words + std::string(" >/dev/full")),
                HasSubstr("3 brdf: standard output: writing broke off: No space left on device"))
        << words;
    EXPECT_THAT(seen(words + std::string(" >&-")), HasSubstr("3 brdf: standard output: writing broke off"))
        << words;
  }
}

TEST_F(Outputs, AClosedStandardOutputThatNobodyNeedsIsNoFaultAndNoFileTakesItsPlace) {
  EXPECT_EQ(seen("eval --form lambert d.csv -o o.csv >&-"), "0\n");
  EXPECT_THAT(text("o.csv"), HasSubstr("theta_i,phi_i,theta_o,phi_o,f\n"));
  EXPECT_EQ(seen("eval --form lambert d.csv -o o.csv <&- >&- 2>&-"), "0\n");
}

TEST_F(Outputs, ABrokenPipeEndsTheProgramQuietly) {
  EXPECT_EQ(run("models 2>e | head -n 0; cat e").out, "");
}

TEST_F(Outputs, AnInputIsNotReplaced) {
  const std::string samples = text("s.csv"), material = text("m.json"), directions = text("d.csv");
  expect_refused("fit s.csv --form lambert -o s.csv", "-o s.csv: is the input s.csv");
  expect_refused("fit s.csv --form lambert --report ./s.csv", "--report ./s.csv: is the input s.csv");
  expect_refused("export --material m.json --to glsl -o m.json", "is the input");
  expect_refused("eval --material m.json d.csv -o d.csv", "is the input");
  expect_refused("convert s.csv s.csv", "OUT s.csv: is the input");
  expect_refused("synth --form lambert --grid d.csv+in_plane -o d.csv", "is the input");
  EXPECT_EQ(run("convert s.csv s.html.csv && mv s.html.csv v.html").exit_code, 0);
  expect_refused("validate v.html -o v.html", "is the input");
  // A budget is an input too, given by an option or by a comment of the table.
  const std::string budget = "source,standard_uncertainty,unit,shared_by\nlamp,0.01,relative,table\n";
  write("b.csv", budget);
  write("named.csv", "# budget: b.csv\n" + samples);
  for (const char* words :
       {"fit s.csv --form lambert --budget b.csv -o b.csv",
        "fit s.csv --form lambert --budget b.csv --report b.csv", "fit named.csv --form lambert -o b.csv",
        "fit named.csv --form lambert --report b.csv",
        "compare named.csv s.csv --form lambert --report b.csv",
        "next named.csv --reach d.csv --form lambert --rows 2 -o b.csv"})
    expect_refused(words, "b.csv: is the input ");
  EXPECT_EQ(text("b.csv"), budget);
  EXPECT_EQ(text("s.csv"), samples);
  EXPECT_EQ(text("m.json"), material);
  EXPECT_EQ(text("d.csv"), directions);
}

// The command finds these inputs itself: a texture, an included file, an image of a stack, a plan.
TEST_F(Outputs, AnInputThatNoOptionNamesIsNotReplaced) {
  write("inc.glsl", "float half_of(float x) { return 0.5 * x; }\n");
  write("u.glsl", "#include \"inc.glsl\"\nfloat brdf(vec3 L, vec3 V, float k) { return half_of(k); }\n");
  const std::string included = text("inc.glsl");
  expect_refused("synth --shader u.glsl --set k=0.1 -o inc.glsl", "inc.glsl: is an input of this command");
  EXPECT_EQ(text("inc.glsl"), included);
  ASSERT_EQ(run("synth --form lambert --texels 3x2 --lights 12 -o stack").exit_code, 0);
  const std::string lights = text("stack/lights.csv");
  expect_refused("fit stack --form lambert -o maps --report stack/lights.csv",
                 "is the input stack/lights.csv");
  expect_refused("fit stack --form lambert -o stack", "-o stack: is the folder of the stack");
  ASSERT_EQ(run("plan fit stack --form lambert -o job").exit_code, 0);
  ASSERT_EQ(run("work job").exit_code, 0);
  const std::string plan = text("job/plan.json");
  expect_refused("collect job -o maps --report job/plan.json", "job/plan.json: is an input of this command");
  expect_refused("collect job --json -o maps", "--json: nothing is collected");
  EXPECT_EQ(text("job/plan.json"), plan);
  EXPECT_EQ(text("stack/lights.csv"), lights);
}

TEST_F(Outputs, AnEmptyValueIsNoValue) {
  for (const char* words : {"fit s.csv --form lambert -o ''", "fit s.csv --form lambert --budget ''",
                            "validate s.csv -o ''", "eval --form lambert d.csv -o ''"})
    expect_refused(words, ": the value is empty: give a value, or leave the option out");
}

TEST_F(Outputs, ABrokenLinkAmongTheSamplesIsAFault) {
  ASSERT_EQ(run("synth --form ward -o two.csv").exit_code, 0);
  ASSERT_EQ(run("models > /dev/null && mkdir in && cp s.csv two.csv in && ln -s nowhere in/z.csv").exit_code,
            0);
  const Outcome outcome = run("fit in --form lambert --no-pictures -o out");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.out + outcome.err, HasSubstr("z.csv"));
}

TEST_F(Outputs, TwoOutputsAreTwoFiles) {
  expect_refused("fit s.csv --form lambert -o x.json --report x.json", "is also the output of -o");
  expect_refused("trade --quick -o x.json -o ./x.json", "is also the output of -o");
}

TEST_F(Outputs, WhatCannotBeWrittenIsRefusedBeforeTheWork) {
  // The inputs do not exist. The output must be refused first, before work that would end in other errors.
  expect_refused("fit missing.csv -o no/m.json", "no/m.json: cannot be written");
  expect_refused("fit missing.csv --report no/m.html", "no/m.html: cannot be written");
  expect_refused("validate missing.csv -o no/r.html", "no/r.html: cannot be written");
  expect_refused("validate missing.csv -o r.txt", "must end in .html or .md");
  expect_refused("convert missing.csv no/x.exr", "no/x.exr: cannot be written");
  expect_refused("eval --form lambert missing.csv -o no/x.csv", "no/x.csv: cannot be written");
  expect_refused("trade -o x.txt", "-o x.txt: the ledger is written as .json, .csv or .html");
  expect_refused("trade -o no/x.json", "no/x.json: cannot be written");
  expect_refused("trade --compare missing.json missing.json -o x.json", "--compare writes to stdout");
}

TEST_F(Outputs, OptionsTakeNumbersAsFilesDo) {
  for (const char* number : {"''", "0x10", "nan", "inf", "1e400", "' 3'", "3x"})
    expect_refused("albedo --form lambert --theta " + std::string(number), "must be a finite number");
  expect_refused("albedo --form lambert --theta 10,nan,30", "'nan' must be a finite number");
  for (const char* words :
       {"fit s.csv --max-theta", "fit s.csv --aperture", "synth --form ward -o x.csv --noise",
        "validate s.csv --max-theta", "recommend --tolerance", "recommend --max-cost",
        "render m.json -o x.png --exposure", "lobes m.json -o x.png --theta"})
    expect_refused(words + std::string(" nan"), "'nan' must be a finite number");
  for (const char* seed : {"-1", "100000000000000000000000", "1e3", "''", "0x1", "18446744073709551616"})
    expect_refused("synth --form ward -o x.csv --seed " + std::string(seed), "must be a whole number from 0");
  EXPECT_EQ(run("synth --form ward --step 30 --seed 18446744073709551615 -o x.csv").exit_code, 0);
  EXPECT_EQ(run("albedo --form lambert --theta 1e1,+20,.5").exit_code, 0);
}

TEST_F(Outputs, LimitsAreSaidInShort) {
  expect_refused("fit s.csv --starts -1", "--starts: -1: must be a whole number from 0 to 100000");
  for (const char* memory : {"0", "-1", "1.5G", "1T", "G", "99999999999999G"})
    expect_refused("render m.json -o x.png --memory-limit " + std::string(memory),
                   "must be a whole number above 0, alone or with K, M or G");
}

TEST_F(Outputs, AReportShowsPicturesThatArePngFiles) {
  expect_refused("validate s.csv -o r.html --picture s.csv", "--picture s.csv: is no PNG file");
  write("cut.png", "\x89PNG\r\n\x1a\n");
  expect_refused("validate s.csv -o r.html --picture cut.png",
                 "--picture cut.png: the PNG file ends too soon");
  expect_refused("validate s.csv -o r.md --picture s.csv", "needs -o with a name that ends in .html");
}

TEST_F(Outputs, PrintedCommandsTakeAFilesNameAsOneWord) {
  const std::string name = "m $(touch pwned) `touch pwned`;touch pwned; 'q'.json";
  std::filesystem::rename(folder_.path() / "m.json", folder_.path() / name);
  const std::string quoted = "\"m \\$(touch pwned) \\`touch pwned\\`;touch pwned; 'q'.json\"";
  const Outcome outcome = run("validate " + quoted + " --json");
  EXPECT_EQ(outcome.exit_code, 1) << outcome.err;  // it reflects more than it receives
  int commands = 0;
  const io::Json findings = io::parse_json(outcome.out, "stdout")["findings"];
  for (const io::Json& finding : findings) {
    if (finding["witness"].is_null()) continue;
    write("command", "PATH=" + std::filesystem::path(BRDF_EXECUTABLE).parent_path().string() + ":$PATH\n" +
                         finding["witness"]["command"].get<std::string>());
    EXPECT_THAT(text("command"), Not(HasSubstr("--material"))) << "a material is positional";
    const int status = std::system(("cd '" + folder_.path().string() + "' && bash command >o 2>e").c_str());
    EXPECT_EQ(status, 0) << finding << text("e");
    ++commands;
  }
  EXPECT_GT(commands, 0);
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "pwned"));
}

TEST_F(Outputs, MarkdownHoldsNamesAsTheyAre) {
  const std::string name = "a|b`c`*d*.json";
  std::filesystem::rename(folder_.path() / "m.json", folder_.path() / name);
  EXPECT_EQ(run("validate '" + name + "' -o r.md").exit_code, 1);
  EXPECT_THAT(text("r.md"), HasSubstr("| a\\|b\\`c\\`\\*d\\*.json | energy |"));
  EXPECT_THAT(text("r.md"), HasSubstr("`` brdf albedo 'a\\|b`c`*d*.json' "));
}

TEST_F(Outputs, AFitsJsonIsTheSameEveryTime) {
  const std::string words = "fit s.csv --form lambert --json --report ";
  EXPECT_EQ(run(words + "a.html").out, run(words + "b.html").out);
  EXPECT_EQ(text("a.html"), text("b.html"));
  EXPECT_THAT(run(words + "a.html").out, Not(HasSubstr("seconds")));
}

TEST_F(Outputs, ASolverThatFailsWritesNothingOfItsOwnToTheTerminal) {
  std::string table = "theta_i,phi_i,theta_o,phi_o,f\n";
  for (int theta = 0; theta <= 60; theta += 5) table += "10,180," + std::to_string(theta) + ",0,1e-310\n";
  write("tiny.csv", table);
  EXPECT_EQ(run("fit tiny.csv --form ward").err, "");
  write("huge.csv", "theta_i,phi_i,theta_o,phi_o,f\n10,0,20,0,1e180\n10,0,30,0,2e180\n10,0,40,0,1e300\n");
  EXPECT_EQ(run("fit huge.csv --form ward --metric cosine_l2").err, "");
}

TEST_F(Outputs, AnInterruptedFitKeepsTheMaterialThatIsThere) {
  write("old.json", "old");
  ASSERT_EQ(run("synth --form ward --set alpha=0.1 --grid hemisphere --noise 0.1 -o big.csv").exit_code, 0);
  const Outcome outcome =
      run_interrupted("fit big.csv --form every --starts 1000 -o old.json", folder_.path());
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(text("old.json"), "old");
  EXPECT_THAT(outcome.err, HasSubstr("interrupted: old.json is kept unchanged"));
}

}  // namespace
}  // namespace brdf
