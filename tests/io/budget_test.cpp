// Tests the reader of uncertainty budgets.
#include "io/formats/budget.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/csv/csv.h"
#include "io/files/error.h"
#include "io/files/output.h"
#include "io/files/temporary.h"
#include "io/formats/read.h"

namespace brdf::io {
namespace {

using testing::HasSubstr;

constexpr const char* kBudgetHeader = "source,standard_uncertainty,unit,shared_by\n";

Budget budget_in(const std::string& text) {
  return read_budget(Content{"b.csv", text});
}

std::string refusal_of_budget(const std::string& text) {
  try {
    budget_in(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no refusal";
}

TEST(Budget, ReadsEverySourceWithItsMeaning) {
  const Budget b = budget_in(std::string("# a goniometer\n") + kBudgetHeader +
                             "reference_standard,0.004,relative,table\nzero_theta_o,0.2,degree,light\n"
                             "linearity,1e-3,relative_per_factor_e,table\nstray_light,3e-4,1/sr,row\n"
                             "ageing of the lamp,0.002,relative,table\n");
  ASSERT_EQ(b.sources.size(), 5u);
  EXPECT_EQ(b.sources[1].effect, BudgetEffect::theta_o);
  EXPECT_EQ(b.sources[1].shared_by, SharedBy::light);
  EXPECT_EQ(b.sources[2].effect, BudgetEffect::linearity);
  EXPECT_EQ(b.sources[3].effect, BudgetEffect::stray_light);
  EXPECT_EQ(b.sources[4].effect, BudgetEffect::scale);
  EXPECT_EQ(b.sources[4].standard_uncertainty, 0.002);
  EXPECT_TRUE(b.divides_by_cos_o);
  EXPECT_FALSE(b.divides_by_cos_i);
}

TEST(Budget, StatesTheCosinesByWhichTheInstrumentDivides) {
  const std::string line = "a,0.1,relative,table\n";
  const Budget both =
      budget_in(std::string("# divided_by: cos_theta_i cos_theta_o\n") + kBudgetHeader + line);
  EXPECT_TRUE(both.divides_by_cos_i && both.divides_by_cos_o);
  const Budget neither = budget_in(std::string("# divided_by: nothing\n") + kBudgetHeader + line);
  EXPECT_FALSE(neither.divides_by_cos_i || neither.divides_by_cos_o);
  EXPECT_THAT(refusal_of_budget(std::string("# divided_by: sin\n") + kBudgetHeader + line),
              HasSubstr("line 1: divided_by: 'sin'"));
}

TEST(Budget, RefusesWithTheLine) {
  const auto with = [](const std::string& line) {
    return refusal_of_budget(kBudgetHeader + std::string("a,0.1,relative,table\n") + line + "\n");
  };
  EXPECT_THAT(with("a,0.2,relative,row"), HasSubstr("line 3: the source 'a' is listed twice"));
  EXPECT_THAT(with("b,-1e-9,relative,table"), HasSubstr("line 3: standard_uncertainty '-1e-9' of 'b'"));
  EXPECT_THAT(with("b,nan,relative,table"), HasSubstr("line 3: standard_uncertainty 'nan'"));
  EXPECT_THAT(with("b,1,percent,table"), HasSubstr("line 3: unit 'percent' must be one of relative, degree"));
  EXPECT_THAT(with("b,1,relative,lamp"), HasSubstr("line 3: shared_by 'lamp'"));
  EXPECT_THAT(with("zero_theta_i,1,relative,table"), HasSubstr("the unit of zero_theta_i must be degree"));
  EXPECT_THAT(with("zero_theta_k,1,degree,table"), HasSubstr("did you mean zero_theta_i?"));
  EXPECT_THAT(with("b,1,relative"), HasSubstr("3 columns, but 4 are expected"));
  EXPECT_THAT(refusal_of_budget(""), HasSubstr("holds no header row"));
  EXPECT_THAT(refusal_of_budget(kBudgetHeader), HasSubstr("holds no source of uncertainty"));
  EXPECT_THAT(refusal_of_budget("source,unit\n"), HasSubstr("needs the column standard_uncertainty"));
  EXPECT_THAT(with("b,1e200,relative,row"), HasSubstr("line 3: standard_uncertainty '1e200' of 'b' must be a "
                                                      "number from 0 to 1000"));
  EXPECT_THAT(with("zero_theta_i,91,degree,row"), HasSubstr("must be a number from 0 to 90"));
  EXPECT_THAT(refusal_of_budget("source,unit,shared_by,unit,standard_uncertainty\n"),
              HasSubstr("line 1: the column unit is there twice"));
}

TEST(Budget, RefusesWhatItDoesNotRead) {
  const std::string line = "a,0.1,relative,table\n";
  for (const char* comment : {"divides_by: cos_theta_o", "Divided by: nothing", "divided_by = nothing",
                              "divided_by cos_theta_o", "dividedby: cos_theta_i"})
    EXPECT_THAT(refusal_of_budget("# " + std::string(comment) + "\n" + kBudgetHeader + line),
                HasSubstr("line 1: the comment "))
        << comment;
  EXPECT_EQ(
      budget_in("# instrument: A\n# measured twice\n" + std::string(kBudgetHeader) + line).sources.size(),
      1u);
  EXPECT_THAT(
      refusal_of_budget("source,standard_uncertainty,unit,shared_by,coverage\na,0.1,relative,table,2\n"),
      HasSubstr("line 1: the column 'coverage' is not one of a budget"));
  EXPECT_EQ(
      budget_in("source,standard_uncertainty,unit,shared_by,note\na,0.1,relative,table,x\n").sources.size(),
      1u);
}

TEST(Budget, StatesSomeUncertainty) {
  const std::string zero = std::string(kBudgetHeader) + "a,0,relative,table\n";
  EXPECT_THAT(refusal_of_budget(zero),
              HasSubstr("states no uncertainty, because every standard_uncertainty is 0"));
  EXPECT_EQ(budget_in(zero + "b,0.01,relative,row\n").sources.size(), 2u);
}

TEST(Budget, OfATableIsRefusedWithTheNameOfTheTable) {
  const TemporaryFolder folder;
  SampleTable table;
  table.source = (folder.path() / "a.csv").string();
  const auto refusal = [&](const std::string& named) {
    table.metadata = {{std::string(kBudgetKey), named}};
    try {
      stated_budget(table);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("no refusal");
  };
  EXPECT_THAT(refusal("none.csv"), HasSubstr("a.csv: the comment # budget: none.csv: "));
  EXPECT_THAT(refusal(" "), HasSubstr("a.csv: the comment # budget: names no file"));
}

TEST(Budget, IsFoundByACopyOfTheTableInAnotherFolder) {
  const TemporaryFolder folder;
  write_file_atomically(folder.path() / "b.csv", std::string(kBudgetHeader) + "a,0.01,relative,table\n");
  write_file_atomically(folder.path() / "a.csv",
                        "# budget: b.csv\ntheta_i,phi_i,theta_o,phi_o,f\n0,0,30,0,0.1\n");
  make_folder(folder.path() / "deep/er");
  const auto copied = folder.path() / "deep/er/a.csv";
  write_samples(copied, read_samples(folder.path() / "a.csv"));
  const SampleTable copy = read_samples(copied);
  EXPECT_EQ(copy.find_metadata(kBudgetKey), "../../b.csv");
  EXPECT_EQ(stated_budget(copy)->sources.size(), 1u);
}

}  // namespace
}  // namespace brdf::io
