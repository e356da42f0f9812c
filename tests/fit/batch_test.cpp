// Tests fits of many files: results that are reused, files that fail, and names of results that would
// collide.
#include "fit/file_batch.h"

#include <gtest/gtest.h>

#include <sys/resource.h>

#include <csignal>
#include <filesystem>
#include <fstream>

#include "io/csv/csv.h"
#include "io/files/error.h"
#include "io/files/output.h"
#include "io/files/temporary.h"
#include "io/formats/read.h"
#include "samples.h"

namespace brdf::fit {
namespace {

namespace fs = std::filesystem;

class BatchOfFiles : public ::testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(folder_ / "in");
    for (int k = 0; k < 3; ++k) {
      Material truth = make_material(*find_form("ward"), {"f"});
      truth.terms[0].shape[0] = {0.1 + 0.05 * k, 0.1 + 0.05 * k};
      const fs::path file = folder_ / "in" / ("s" + std::to_string(k) + ".csv");
      io::write_samples(file, measured(truth, {"hemisphere"}, 0.02));
      files_.push_back(file.string());
    }
    batch_ = {.folder = folder_ / "out", .jobs = 2, .settings = "settings", .spheres = false};
    options_.cross_validation = false;
  }

  std::vector<BatchRow> run() { return run_batch(files_, {forms({"ward"})}, options_, batch_); }

  const io::TemporaryFolder temporary_;
  const fs::path folder_ = temporary_.path();
  std::vector<std::string> files_;
  BatchOptions batch_;
  FitOptions options_;
};

TEST_F(BatchOfFiles, KeepsWhatIsFinishedAndRedoesTheRest) {
  for (const BatchRow& row : run()) EXPECT_FALSE(row.reused);
  fs::remove(folder_ / "out" / "s1.fit.json");  // as if killed before the second file was finished
  const auto again = run();
  EXPECT_TRUE(again[0].reused);
  EXPECT_FALSE(again[1].reused);
  EXPECT_TRUE(again[2].reused);
  EXPECT_EQ(again[0].best["form"], "ward");
}

TEST_F(BatchOfFiles, RedoesFilesAndSettingsThatChanged) {
  run();
  std::ofstream(files_[2], std::ios::app) << "10,180,20,0,0.3\n";
  auto rows = run();
  EXPECT_TRUE(rows[0].reused);
  EXPECT_FALSE(rows[2].reused);
  batch_.settings = "others";
  for (const BatchRow& row : run()) EXPECT_FALSE(row.reused);
}

// This includes an edited report that has no ranking, no row, no name of the form or no numeric error.
TEST_F(BatchOfFiles, RedoesAFileWhoseBudgetChanged) {
  const auto state = [&](const char* uncertainty) {
    io::write_file_atomically(folder_ / "in" / "budget.csv",
                              std::string("source,standard_uncertainty,unit,shared_by\nreference_standard,") +
                                  uncertainty + ",relative,table\n");
  };
  state("0.01");
  std::ifstream in(files_[1]);
  const std::string rows((std::istreambuf_iterator<char>(in)), {});
  io::write_file_atomically(files_[1], "# budget: budget.csv\n" + rows);
  EXPECT_EQ(run()[1].best["intervals_contain"], "scatter and budget");
  for (const BatchRow& row : run()) EXPECT_TRUE(row.reused);
  state("0.02");
  const auto again = run();
  EXPECT_TRUE(again[0].reused);
  EXPECT_FALSE(again[1].reused);
}

TEST_F(BatchOfFiles, RedoesReportsThatWereEdited) {
  run();
  const fs::path report = folder_ / "out" / "s0.fit.json";
  for (const char* path : {"/ranking/0", "/ranking/0/form", "/ranking/0/median_relative_error", "/ranking"}) {
    io::Json json = io::read_json(report);
    json[io::Json::json_pointer(path)] = io::Json::object();
    io::write_file_atomically(report, io::to_text(json));
    const auto rows = run();
    EXPECT_FALSE(rows[0].reused) << path;
    EXPECT_EQ(rows[0].best["form"], "ward");
    EXPECT_TRUE(rows[1].reused);
  }
  fs::remove(folder_ / "out" / "s2.html");
  EXPECT_FALSE(run()[2].reused);
}

TEST_F(BatchOfFiles, OneBadFileDoesNotStopTheOthers) {
  options_.cross_validation = true;
  std::ofstream(files_[1]) << "theta_i,phi_i,theta_o,phi_o,f\n10,0,20,x,0.1\n";
  std::vector<std::string> said;
  batch_.progress = [&](const std::string& line) { said.push_back(line); };
  const auto rows = run();
  EXPECT_TRUE(usable(rows[0]));
  EXPECT_FALSE(usable(rows[1]));
  for (const std::string& line : said)  // each line names its file, once
    EXPECT_EQ(line.find(".csv"), line.rfind(".csv")) << line;
  EXPECT_EQ(said.size(), 3u);
  EXPECT_NE(rows[1].error.find("line 2"), std::string::npos) << rows[1].error;
  EXPECT_TRUE(usable(rows[2]));
  write_summary(rows, batch_.folder);
  std::ifstream csv(batch_.folder / "summary.csv");
  std::vector<std::string> lines;
  for (std::string line; std::getline(csv, line);) lines.push_back(line);
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_TRUE(lines[0].starts_with("file,form,verdict,left_out,"));
  const io::Json best = io::read_json(batch_.folder / "s0.fit.json")["ranking"][0];
  EXPECT_NE(lines[1].find(",converged," + best["left_out"].dump() + ","), std::string::npos) << lines[1];
  EXPECT_GT(fs::file_size(batch_.folder / "summary.html"), 10000u);
  EXPECT_GT(fs::file_size(batch_.folder / "s0.html"), 10000u);
}

TEST_F(BatchOfFiles, AnExceptionOfAnyKindEndsItAndIsThrown) {
  batch_.progress = [](const std::string&) { throw std::runtime_error("no more"); };
  EXPECT_THROW(run(), std::runtime_error);
}

TEST_F(BatchOfFiles, WhatTheEnvironmentRefusesIsARowAndEndsNoOther) {
  const auto before = std::signal(SIGXFSZ, SIG_IGN);
  rlimit old{};
  getrlimit(RLIMIT_FSIZE, &old);
  const rlimit small{8, old.rlim_max};
  setrlimit(RLIMIT_FSIZE, &small);
  const auto rows = run();
  setrlimit(RLIMIT_FSIZE, &old);
  std::signal(SIGXFSZ, before);
  for (const BatchRow& row : rows) {
    EXPECT_TRUE(row.environment_failed);
    EXPECT_NE(row.error.find("File too large"), std::string::npos) << row.error;
  }
}

TEST_F(BatchOfFiles, NoResultTakesTheNameOfTheSummaryOrOfAnotherResult) {
  const auto renamed = [&](std::size_t k, const char* name) {
    const fs::path to = folder_ / "in" / name;
    fs::rename(files_[k], to);
    files_[k] = to.string();
  };
  renamed(0, "summary.csv");
  renamed(2, "s1.fit.csv");  // its material would be s1.fit.json, the statistics of s1
  const auto rows = run();
  EXPECT_EQ(rows[0].name, "summary.csv");
  EXPECT_EQ(rows[1].name, "s1");
  EXPECT_EQ(rows[2].name, "s1.fit.csv");
}

TEST_F(BatchOfFiles, ASampleFileIsNotReplacedByAResult) {
  const fs::path to = folder_ / "in" / "s0.json";  // the content of a file decides its format
  fs::rename(files_[0], to);
  files_[0] = to.string();
  batch_.folder = folder_ / "in";
  EXPECT_THROW(run(), InputError);
  EXPECT_EQ(io::read_samples(to).format, "csv");
}

TEST_F(BatchOfFiles, AFileWithoutASolutionIsARowAndNoMaterial) {
  std::ofstream(files_[1]) << "theta_i,phi_i,theta_o,phi_o,f\n10,0,20,0,1e180\n10,0,30,0,2e180\n";
  options_.metric = Metric::cosine_l2;
  const auto rows = run();
  EXPECT_EQ(rows[1].error, "the cost was not finite at any starting point");
  EXPECT_FALSE(fs::exists(batch_.folder / "s1.json"));
  EXPECT_TRUE(fs::exists(batch_.folder / "s2.json"));
}

TEST_F(BatchOfFiles, FilesWhoseResultsWouldOverwriteEachOtherAreRefused) {
  files_.push_back(files_[0]);  // its results would be s0.csv, but the stem is taken
  EXPECT_EQ(run().back().name, "s0.csv");
  files_.push_back(files_[0]);
  EXPECT_THROW(run(), InputError);
}

}  // namespace
}  // namespace brdf::fit
