#include "study/verdict.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace brdf::study {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

fit::FitResult good_fit() {
  fit::FormFit best;
  best.form = "some_form";
  best.verdict = fit::Verdict::converged;
  best.median_relative_error = 0.02;
  best.minima.resize(1);
  best.largest_albedo = fit::LargestAlbedo{0.8, 0, "r"};
  best.lack_of_fit.residual_over_scatter = 1.0;
  for (const char* channel : {"r", "g"}) {
    fit::Estimate e;
    e.name = "weight";
    e.channel = channel;
    e.value = 0.5;
    e.low = 0.4;
    e.high = 0.6;
    best.estimates.push_back(e);
  }
  fit::FitResult result;
  result.ranking = {best};
  return result;
}

TEST(Judgement, IsGoodWhereNothingSpeaksAgainstIt) {
  const Judgement judgement = judge(good_fit());
  EXPECT_EQ(judgement.mark, io::Mark::good);
  EXPECT_EQ(judgement.sentence, "some_form describes the samples, to 2 % in the median.");
  EXPECT_THAT(judgement.warnings, IsEmpty());
}

TEST(Judgement, WarnsOfParametersThatAreHardlyKnown) {
  fit::FitResult result = good_fit();
  result.ranking[0].estimates[1].high = 1.21;  // just over three times the low end
  EXPECT_EQ(judge(result).mark, io::Mark::warn);
  EXPECT_THAT(weakly_determined(result.ranking[0]), ElementsAre("weight (g)"));
  EXPECT_THAT(judge(result).warnings, Contains(HasSubstr("weakly determined: weight (g)")));
  result.ranking[0].estimates[1].high = 1.19;
  EXPECT_EQ(judge(result).mark, io::Mark::good);
  result.ranking[0].estimates[1].with_lack_of_fit = {0, 1.19};  // the wider one counts
  EXPECT_EQ(judge(result).mark, io::Mark::warn);
  result.ranking[0].estimates[1].status = fit::Status::fixed;
  EXPECT_EQ(judge(result).mark, io::Mark::good);
}

TEST(Judgement, ATraceThatCouldBeNothingIsNoWarning) {
  fit::FitResult result = good_fit();
  fit::Estimate& e = result.ranking[0].estimates[0];
  e.value = 0.002, e.low = 0, e.high = 0.04;
  EXPECT_EQ(judge(result).mark, io::Mark::good);
}

TEST(Judgement, WarnsOfEnergyAndLackOfFit) {
  fit::FitResult bright = good_fit();
  bright.ranking[0].findings = {"reflects more light than falls on it"};  // as fit says it
  EXPECT_EQ(judge(bright).mark, io::Mark::warn);
  EXPECT_THAT(judge(bright).warnings, ElementsAre("reflects more light than falls on it"));
  fit::FitResult off = good_fit();
  off.ranking[0].lack_of_fit.beyond_scatter = true;
  EXPECT_EQ(judge(off).mark, io::Mark::warn);
  EXPECT_THAT(judge(off).sentence, HasSubstr("comes closest: off by 2 %"));
  EXPECT_THAT(judge(off).warnings, Contains(HasSubstr("lack of fit: ")));
}

TEST(Judgement, WhatCannotBeUsedIsBad) {
  for (const fit::Verdict verdict :
       {fit::Verdict::misfit, fit::Verdict::not_identifiable, fit::Verdict::interrupted}) {
    fit::FitResult result = good_fit();
    result.ranking[0].verdict = verdict;
    EXPECT_EQ(judge(result).mark, io::Mark::bad) << name_of(verdict);
  }
  fit::FitResult none = good_fit();
  none.ranking[0].minima.clear();
  none.ranking[0].verdict = fit::Verdict::diverged;
  EXPECT_EQ(judge(none).sentence, "No form could be fitted.");
}

}  // namespace
}  // namespace brdf::study
