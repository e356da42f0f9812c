// Tests `brdf study` through the executable: exit codes, output, and the continuation of a killed run.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <spawn.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <set>
#include <thread>

#include "io/files/json.h"
#include "tests/cli/run_brdf.h"

namespace brdf {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::StartsWith;

class StudyVerb : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(
        run("synth --form ward --set alpha=0.2 --grid in_plane --theta-i 10,30,50 --step 10 --noise 0.02 "
            "-o s.csv")
            .exit_code,
        0);
  }
  Outcome run(const std::string& arguments) { return run_brdf(arguments, folder_.path()); }
  io::Json json_of(const Outcome& outcome) { return io::parse_json(outcome.out, "stdout"); }
  void write(const std::string& name, const std::string& text) {
    std::ofstream(folder_.path() / name) << text;
  }

  pid_t start(std::vector<std::string> words) {
    words.insert(words.begin(), BRDF_EXECUTABLE);
    std::vector<char*> arguments;
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    pid_t process = -1;
    EXPECT_EQ(posix_spawn(&process, BRDF_EXECUTABLE, &actions, nullptr, arguments.data(), environ), 0);
    posix_spawn_file_actions_destroy(&actions);
    return process;
  }

  io::TemporaryFolder folder_;
};

TEST_F(StudyVerb, WritesThePageOfOneSample) {
  const Outcome outcome = run("study s.csv --form ward -o out");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, StartsWith("s  warning: ward fits the measurements: median error (fitted) "));
  EXPECT_THAT(outcome.out, HasSubstr("\nout/index.html\n"));
  EXPECT_TRUE(fs::exists(folder_.path() / "out/material.json"));
  EXPECT_THAT(run("study s.csv --form ward -o out").out, HasSubstr(" (kept)\n"));
  EXPECT_FALSE(json_of(run("study s.csv --form lambert+ward -o out --json"))["results"][0]["kept"]);
  EXPECT_EQ(run("eval --material out/material.json s.csv -o e.csv").exit_code, 0);
}

TEST_F(StudyVerb, PicturesNeedNoDriver) {
  const Setting driver("VK_DRIVER_FILES", "/none"), older("VK_ICD_FILENAMES", "/none");
  const io::Json row = json_of(run("study s.csv --form ward -o out --json"))["results"][0];
  EXPECT_TRUE(row["no_pictures"].is_null());
  EXPECT_TRUE(fs::exists(folder_.path() / "out/fitted.png"));
  EXPECT_EQ(json_of(run("study s.csv --form ward -o out --json"))["results"][0]["kept"], true);
}

TEST_F(StudyVerb, ExitCodesSayWhatFailed) {
  write("broken.csv", "theta_i,phi_i,theta_o,phi_o,f\n1,2,x,4,5\n");
  const Outcome one = run("study s.csv broken.csv --form ward -o out --json");
  EXPECT_EQ(one.exit_code, 1) << one.err;
  const io::Json results = json_of(one)["results"];
  EXPECT_TRUE(results[0]["usable"]);
  EXPECT_THAT(results[1]["error"].get<std::string>(), HasSubstr("broken.csv, line 2: column 3"));
  EXPECT_EQ(run("study s.csv --form lambert -o bad").exit_code, 1);  // a shiny sample
  for (const char* words : {"study broken.csv -o none", "study broken.csv missing.csv -o none",
                            "study s.csv --form wurd -o none", "study s.csv", "study s.csv -o s.csv",
                            "study s.csv --jobs 0 -o none", "study s.csv --robust x -o none"}) {
    const Outcome refused = run(words);
    EXPECT_EQ(refused.exit_code, 2) << words;
    EXPECT_THAT(refused.err, StartsWith("brdf: ")) << words;
    EXPECT_EQ(std::count(refused.err.begin(), refused.err.end(), '\n'), 1) << refused.err;
  }
  EXPECT_FALSE(fs::exists(folder_.path() / "none"));
}

TEST_F(StudyVerb, NamesThatAreNoWebAddressesAreLinked) {
  const std::string name = "50% grey #2 & <b> \"q\"?.csv";
  fs::copy_file(folder_.path() / "s.csv", folder_.path() / name);
  EXPECT_EQ(run("study s.csv '" + name + "' --form ward -o out").exit_code, 0);
  EXPECT_THAT(file_text(folder_.path() / "out/index.html"),
              HasSubstr("href=\"50%25%20grey%20%232%20%26%20%3Cb%3E%20%22q%22%3F/index.html\""));
}

// A study of 30 samples, two at a time, is killed while it works. The next run must keep all finished
// samples.
// The last line names the page only if there is one.
TEST_F(StudyVerb, AnInterruptedStudyOfOneSampleNamesNoPage) {
  ASSERT_EQ(run("synth --form ward --set alpha=0.1 --grid hemisphere --noise 0.1 -o big.csv").exit_code, 0);
  const Outcome left = run_interrupted("study big.csv --form every --starts 1000 -o studied", folder_.path());
  EXPECT_EQ(left.exit_code, 1);
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "studied" / "index.html"));
  EXPECT_THAT(left.out, testing::Not(testing::HasSubstr("index.html")));
}

TEST_F(StudyVerb, KilledAndRunAgainItRedoesOnlyWhatWasInFlight) {
  constexpr std::size_t kSamples = 30, kJobs = 2;
  const std::string table = file_text(folder_.path() / "s.csv");
  std::vector<std::string> words{"study",  "--form",
                                 "ward",   "--no-pictures",
                                 "--jobs", std::to_string(kJobs),
                                 "-o",     (folder_.path() / "out").string()};
  std::string again =
      "study --form ward --no-pictures --jobs 2 -o '" + (folder_.path() / "out").string() + "' --json";
  for (std::size_t k = 0; k < kSamples; ++k) {
    const fs::path file = folder_.path() / ("sample" + std::to_string(k) + ".csv");
    std::ofstream(file) << "# sample: " << k << '\n' << table;
    words.push_back(file.string());
    again += " '" + file.string() + "'";
  }
  const auto finished = [&] {
    std::set<std::string> names;
    std::error_code none_yet;
    for (const auto& entry : fs::directory_iterator(folder_.path() / "out", none_yet))
      if (fs::exists(entry.path() / "study.json")) names.insert(entry.path().filename());
    return names;
  };
  const pid_t process = start(words);
  ASSERT_GT(process, 0);
  for (int k = 0; k < 6000 && finished().size() < 8; ++k)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
  kill(process, SIGKILL);
  int status = 0;
  waitpid(process, &status, 0);
  EXPECT_TRUE(WIFSIGNALED(status));
  const std::set<std::string> before = finished();
  EXPECT_GE(before.size(), 8u);
  EXPECT_LT(before.size(), kSamples);
  std::size_t folders = 0;
  for (const auto& entry : fs::directory_iterator(folder_.path() / "out")) folders += entry.is_directory();
  EXPECT_LE(folders, before.size() + kJobs);

  const Outcome outcome = run(again);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const io::Json results = json_of(outcome)["results"];
  ASSERT_EQ(results.size(), kSamples);
  std::set<std::string> kept;
  for (const io::Json& row : results)
    if (row["kept"]) kept.insert(row["name"]);
  EXPECT_EQ(kept, before);
  EXPECT_EQ(finished().size(), kSamples);
  RecordProperty("kept", int(kept.size()));
}

}  // namespace
}  // namespace brdf
