// Tests the first screen of a page: facts about the measurements, tolerance, energy and next step.
#include "fit/report/first_screen.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fit/report/html.h"
#include "fit/report/states.h"
#include "io/files/error.h"
#include "samples.h"

namespace brdf::fit {
namespace {

using testing::HasSubstr;
using testing::Not;

io::SampleTable table_of(const std::vector<std::string>& channels = {"f"}) {
  return measured(make_material(*find_form("ward"), channels), {"hemisphere"}, 0.02);
}

std::string value_of(const std::vector<io::Fact>& facts, const std::string& name) {
  for (const io::Fact& fact : facts)
    if (fact.name == name) return fact.value;
  return "missing";
}

TEST(FirstScreen, AFactThatTheHeaderDoesNotStateIsEmpty) {
  io::SampleTable table = table_of();
  table.metadata = {{"", "free text"}, {"Operator", "A. Weaver"}, {"material", "{\"form\": \"ward\"}"}};
  const std::vector<io::Fact> facts = facts_of(table);
  EXPECT_EQ(value_of(facts, "operator"), "A. Weaver");
  for (const char* name : {"material", "instrument", "date"}) EXPECT_EQ(value_of(facts, name), "") << name;
  const std::string page = html_report(fit(table, {forms({"ward"})}, {}), table, {}, false);
  EXPECT_THAT(page, HasSubstr("<li>date: <i>not stated</i></li>"));
  EXPECT_THAT(page, HasSubstr("<li>operator: <b>A. Weaver</b></li>"));
}

TEST(FirstScreen, ChannelsAndRowsAreCounted) {
  io::SampleTable table;
  table.channels = {"400nm", "500nm", "600nm", "700nm", "780nm"};
  table.values.resize(5);
  for (int k = 0; k < 1200; ++k) {
    table.add_directions(k % 2 ? 20 : 60.5, 0, k % 80, 180);
    for (auto& channel : table.values) channel.push_back(1);
  }
  const std::vector<io::Fact> facts = facts_of(table);
  EXPECT_EQ(facts[4].value, "5 wavelengths, 400 to 780 nm");
  EXPECT_EQ(facts[5].value, "1,200 measurements, 2 angles of incidence, 20 to 60.5\u00b0");
  table.channels = {"r", "g", "b"};
  EXPECT_EQ(facts_of(table)[4].value, "3 channels (r, g, b)");
}

// The page judges by the number of the headline, and the box by the same measurements.
TEST(FirstScreen, TheMedianOfTheQuantilesIsTheMedianOfTheFit) {
  const io::SampleTable table = table_of({"r", "g"});
  for (const char* form : {"ward", "lambert"}) {
    const FitResult result = fit(table, {forms({form})}, {});
    const FormFit& best = result.ranking.front();
    const ErrorQuantiles quantiles = error_quantiles(best, table, {});
    ASSERT_EQ(quantiles.errors.size(), ErrorQuantiles::kSteps + 1u);
    EXPECT_NEAR(quantiles.errors[ErrorQuantiles::kSteps / 2], best.median_relative_error,
                1e-12 * best.median_relative_error)
        << form;
  }
}

// A file that states the detector's width is fitted, judged and drawn with this width, as if --aperture gave
// the width. --aperture 0 turns the width off.
TEST(FirstScreen, AStatedApertureHoldsForTheFitAndForThePage) {
  io::SampleTable stated = table_of();
  stated.metadata.emplace_back("detector_aperture", "8 degrees");
  FitOptions given, off;
  given.aperture = 8;
  off.aperture = 0;
  const auto median = [&](const io::SampleTable& table, const FitOptions& options) {
    return fit(table, {forms({"ward"})}, options).ranking.front().median_relative_error;
  };
  EXPECT_EQ(median(stated, {}), median(table_of(), given));
  EXPECT_EQ(median(stated, off), median(table_of(), {}));
  EXPECT_NE(median(stated, {}), median(stated, off));
  const FitResult result = fit(stated, {forms({"ward"})}, {});
  const FormFit& best = result.ranking.front();
  EXPECT_NEAR(error_quantiles(best, stated, {}).errors[ErrorQuantiles::kSteps / 2],
              best.median_relative_error, 1e-12 * best.median_relative_error);
  EXPECT_NE(error_quantiles(best, stated, off).errors, error_quantiles(best, stated, {}).errors);
}

TEST(FirstScreen, AnApertureIsNotReadBeforeItIsResolved) {
  EXPECT_THROW(FitOptions{}.resolved_aperture(), std::logic_error);
}

TEST(FirstScreen, AToleranceIsAPercentageOrAShare) {
  EXPECT_DOUBLE_EQ(tolerance_of("5%"), 0.05);
  EXPECT_DOUBLE_EQ(tolerance_of(" 2.5 % "), 0.025);
  EXPECT_DOUBLE_EQ(tolerance_of("0.05"), 0.05);
  EXPECT_DOUBLE_EQ(tolerance_of("1"), 1);
  for (const char* bad : {"", "x", "%", "0", "-5%", "5", "101%", "nan", "5%%"})
    EXPECT_THROW(tolerance_of(bad), InputError) << bad;
}

TEST(FirstScreen, AFitIsWithinOrOutsideTheTolerance) {
  FormFit f;
  f.minima.resize(1);
  f.median_relative_error = 0.033;
  EXPECT_EQ(tolerance_sentence(f, 0.05),
            "Within the tolerance: the median error (fitted), 3.3 %, is at most 5 %.");
  EXPECT_EQ(tolerance_sentence(f, 0.03),
            "Outside the tolerance: the median error (fitted), 3.3 %, is above 3 %.");
  EXPECT_TRUE(is_within(f, 0.033));
  f.median_relative_error = kUnknown;
  EXPECT_FALSE(is_within(f, 1));
  f.median_relative_error = 0.001;
  f.minima.clear();  // nothing was fitted
  EXPECT_FALSE(is_within(f, 1));
}

TEST(FirstScreen, UndecidedEnergyIsNamedWithItsRemedy) {
  const io::SampleTable table = table_of();
  FitResult result = fit(table, {forms({"ward"})}, {});
  FormFit& best = result.ranking.front();
  best.about = {};
  best.about.scatter = best.about.least_scatter = 0.02;
  best.lack_of_fit = {};
  best.lack_of_fit.residual_over_scatter = 1;
  EXPECT_EQ(next_step(result), "");
  for (const io::Remark& remark : energy_remarks(result)) EXPECT_EQ(remark.mark, io::Mark::good);
  // A table that a program computed has no data sheet.
  result.sheet.findings = {{.subject = "t", .check = "energy", .statement = "it may exceed 1"}};
  sheet::Finding* const energy = &result.sheet.findings.front();
  EXPECT_EQ(next_step(result), "");
  energy->outcome = sheet::Outcome::undecided;
  result.sheet.albedo = {
      {.theta_i = 20, .coverage = 1, .value = {0.5}, .bound = {0.1}, .least = {}, .in_plane = {}},
      {.theta_i = 75, .coverage = 1, .value = {0.9}, .bound = {0.4}, .least = {}, .in_plane = {}}};
  EXPECT_THAT(next_step(result), HasSubstr("at incidence 75 degrees"));
  EXPECT_EQ(energy_remarks(result).back().mark, io::Mark::unknown);
  EXPECT_THAT(energy_remarks(result).back().text, HasSubstr("undecided"));
  energy->is_suspicion = true;  // the verdict names it already
  EXPECT_THAT(energy_remarks(result), testing::SizeIs(1));
  result.sheet.albedo.clear();
  EXPECT_THAT(next_step(result), HasSubstr("outside the plane of incidence"));
}

TEST(FirstScreen, ADoubtfulFitNamesTheNextStep) {
  const io::SampleTable table = table_of();
  FitResult result = fit(table, {forms({"ward"})}, {});
  FormFit& best = result.ranking.front();
  best.about = {};
  best.lack_of_fit = {};
  EXPECT_THAT(next_step(result), HasSubstr("repeat some measurements"));
  best.lack_of_fit.residual_over_scatter = 3;
  best.lack_of_fit.beyond_scatter = true;
  EXPECT_THAT(next_step(result), HasSubstr("--form all"));
  best.verdict = Verdict::misfit;
  EXPECT_THAT(next_step(result), HasSubstr("--form all"));
  result.ranking.push_back(best);
  EXPECT_THAT(next_step(result), HasSubstr("--form auto"));
}

// A column of the ranking never mixes errors of two kinds.
TEST(FirstScreen, AFormWithoutFoldsHasNoHeldOutError) {
  const io::SampleTable table = table_of();
  FitResult result = fit(table, {forms({"ward"}), forms({"lambert"})}, {});
  ASSERT_TRUE(result.ranking[1].left_out);
  result.ranking[1].left_out.reset();
  const std::string page = html_report(result, table, {}, false);
  const std::size_t row = page.find(result.ranking[1].form + "</code>", page.find("median error (held out)"));
  ASSERT_NE(row, std::string::npos);
  const std::string cells = page.substr(row, page.find("</tr>", row) - row);
  std::size_t dashes = 0;
  for (std::size_t at = 0; (at = cells.find(">-<", at)) != cells.npos; ++at) ++dashes;
  EXPECT_GE(dashes, 4u) << cells;  // held out, median, 90 %, off by 2
}

}  // namespace
}  // namespace brdf::fit
