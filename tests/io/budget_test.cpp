// Tests the reader of uncertainty budgets.
#include "io/formats/budget.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/files/error.h"

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
}

}  // namespace
}  // namespace brdf::io
