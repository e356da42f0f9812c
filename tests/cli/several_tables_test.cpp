// Tests the verbs that compare tables of one surface: exit codes, budgets, messages.
#include <fstream>

#include "io/files/json.h"
#include "run_brdf.h"

namespace brdf {
namespace {

constexpr const char* kBudget =
    "source,standard_uncertainty,unit,shared_by\n"
    "reference_standard,0.01,relative,table\n"
    "zero_theta_i,0.15,degree,table\n"
    "zero_theta_o,0.15,degree,table\n"
    "repeatability,0.01,relative,row\n";

// Measures a surface of this width.
void measure(const std::filesystem::path& folder, const std::string& name, const std::string& alpha,
             int seed) {
  const Outcome made = run_brdf("synth --form cook_torrance --set alpha=" + alpha +
                                    " --set ks=1 --set kd=0.3 --set f0=0.04 --theta-i 0,15,30,45,60 --grid "
                                    "hemisphere --step 15 --noise 0.01 --seed " +
                                    std::to_string(seed) + " -o " + name,
                                folder);
  ASSERT_EQ(made.exit_code, 0) << made.err;
}

class SeveralTables : public testing::Test {
 protected:
  void SetUp() override {
    measure(folder_, "a.csv", "0.25", 1);
    measure(folder_, "b.csv", "0.25", 2);
    measure(folder_, "wide.csv", "0.28", 3);
    std::ofstream(folder_ / "budget.csv") << kBudget;
  }
  Outcome run(const std::string& words) { return run_brdf(words + kFit, folder_); }

  static constexpr const char* kFit = " --form cook_torrance --fix f0=0.04";
  io::TemporaryFolder temporary_;
  std::filesystem::path folder_ = temporary_.path();
};

TEST_F(SeveralTables, CompareHasAnExitCodeForEachAnswer) {
  const Outcome same = run("compare a.csv b.csv --budget budget.csv");
  EXPECT_EQ(same.exit_code, 0) << same.out << same.err;
  EXPECT_NE(same.out.find("\nno difference beyond the budgets"), std::string::npos) << same.out;
  const Outcome other = run("compare a.csv wide.csv --budget budget.csv --budget budget.csv");
  EXPECT_EQ(other.exit_code, 1) << other.out << other.err;
  EXPECT_NE(other.out.find("\ndifferent beyond the budgets: alpha"), std::string::npos) << other.out;
  for (const char* pair : {"compare a.csv b.csv", "compare a.csv wide.csv"}) {
    const Outcome open = run(pair);
    EXPECT_EQ(open.exit_code, 4) << open.out << open.err;
    EXPECT_NE(open.out.find("\ncannot be told: "), std::string::npos) << open.out;
    EXPECT_EQ(open.out.find("beyond the budgets"), std::string::npos) << open.out;
    EXPECT_EQ(open.out.find(" p "), std::string::npos) << open.out;
  }
}

TEST_F(SeveralTables, ABudgetInTheHeadersIsUsed) {
  for (const char* name : {"a.csv", "wide.csv"}) {
    const std::string text = file_text(folder_ / name);
    std::ofstream(folder_ / name) << "# budget: budget.csv\n" << text;
  }
  EXPECT_EQ(run("compare a.csv wide.csv").exit_code, 1);
  const Outcome mixed = run("compare a.csv b.csv");
  EXPECT_EQ(mixed.exit_code, 2);
  EXPECT_NE(mixed.err.find("b.csv has no uncertainty budget, but a.csv has one"), std::string::npos)
      << mixed.err;
}

TEST_F(SeveralTables, ConsensusGivesEveryNumberAsJson) {
  const Outcome said = run("consensus a.csv b.csv wide.csv --budget budget.csv --at 0:45 --at 30:30 --json");
  ASSERT_EQ(said.exit_code, 0) << said.err;
  const io::Json json = io::Json::parse(said.out);
  EXPECT_TRUE(json["budget"].get<bool>());
  EXPECT_EQ(json["quantities"][0]["name"], "f(0:45)");
  EXPECT_EQ(json["quantities"][1]["name"], "f(30:30)");
  EXPECT_EQ(json["quantities"][2]["name"], "alpha");
  EXPECT_GT(json["quantities"][2]["consensus"]["between"].get<double>(), 0.03);
}

TEST_F(SeveralTables, ReportsArePages) {
  EXPECT_EQ(run("compare a.csv wide.csv --budget budget.csv --report difference.html").exit_code, 1);
  EXPECT_NE(file_text(folder_ / "difference.html").find("Different beyond the budgets"), std::string::npos);
  EXPECT_EQ(run("consensus a.csv b.csv --report consensus.html").exit_code, 0);
  EXPECT_NE(file_text(folder_ / "consensus.html").find("degree of equivalence"), std::string::npos);
}

TEST_F(SeveralTables, BadCallsAreRefusedBeforeAnyFit) {
  for (const char* verb : {"compare", "consensus"}) {
    const Outcome seeded = run(std::string(verb) + " a.csv b.csv --seed 3");
    EXPECT_EQ(seeded.exit_code, 2) << verb;
    EXPECT_NE(seeded.err.find("--seed: has no effect without --starts"), std::string::npos) << seeded.err;
  }
  const std::pair<const char*, const char*> calls[] = {
      {"compare a.csv", "SAMPLES: two tables are compared"},
      {"compare a.csv b.csv wide.csv", "SAMPLES: two tables are compared"},
      {"compare a.csv a.csv", "a.csv is named twice"},
      {"compare a.csv ./a.csv", "./a.csv is the same file as a.csv"},
      {"consensus a.csv", "SAMPLES: at least two tables are needed"},
      {"consensus a.csv b.csv wide.csv --budget budget.csv --budget budget.csv",
       "--budget: given 2 times for 3 tables"},
      {"consensus a.csv b.csv --at 0:95", "--at 0:95: polar angles must be at least 0 and below 90 degrees"},
      {"consensus a.csv b.csv --budget missing.csv", "missing.csv"},
      {"compare a.csv b.csv --report a.csv", "a.csv"}};
  const std::string before = file_text(folder_ / "a.csv");
  for (const auto& [words, message] : calls) {
    const Outcome said = run(words);
    EXPECT_EQ(said.exit_code, 2) << words << said.out;
    EXPECT_NE(said.err.find(message), std::string::npos) << said.err;
  }
  EXPECT_EQ(file_text(folder_ / "a.csv"), before);
}

}  // namespace
}  // namespace brdf
