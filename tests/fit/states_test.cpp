// Tests every row of the table of states in the terminal, in JSON and on the page.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "fit/report/html.h"
#include "fit/report/report.h"
#include "fit/report/states.h"
#include "samples.h"

namespace brdf::fit {
namespace {

using testing::HasSubstr;

// Returns a good fit of one channel, which the tests then spoil.
FitResult good() {
  const Material truth = make_material(*find_form("lambert"), {"f"});
  FitResult result = fit(measured(truth, {"hemisphere"}, 0.02), {forms({"lambert"})}, {});
  FormFit& f = result.ranking.front();
  f.median_relative_error = 0.02;
  f.lack_of_fit = {};
  f.lack_of_fit.residual_over_scatter = 0.9;
  f.about.scatter = f.about.least_scatter = 0.032;
  f.about.hidden_width.reset();
  return result;
}

struct Row {
  const char* name;
  std::function<void(FormFit&)> spoil;
  io::Mark mark;
  bool usable;
  const char* sentence;
};

std::vector<Row> rows() {
  using io::Mark;
  const auto verdict = [](Verdict v) { return [v](FormFit& f) { f.verdict = v; }; };
  return {
      {"describes", [](FormFit&) {}, Mark::good, true,
       "lambert fits the measurements: median error (fitted) 2 %, consistent with the measurement noise (3.2 "
       "%)."},
      {"exact", [](FormFit& f) { f.lack_of_fit.exact = true, f.median_relative_error = 1e-13; }, Mark::good,
       true, "fits the measurements to rounding: median error (fitted) at most 1e-9 %"},
      {"roughly",
       [](FormFit& f) { f.lack_of_fit.beyond_scatter = true, f.lack_of_fit.residual_over_scatter = 4.3; },
       Mark::warn, true,
       "lambert fits the measurements only roughly: median error (fitted) 2 %; the residuals are 4.3 times "
       "the "
       "measurement noise."},
      {"scatter_unknown", [](FormFit& f) { f.lack_of_fit.residual_over_scatter.reset(); }, Mark::unknown,
       true,
       "lambert has a median error (fitted) of 2 %; lack of fit cannot be judged, because the measurement "
       "noise is "
       "not known."},
      {"scatter_unknown, symmetric rows differ", [](FormFit& f) { f.about.least_scatter = 0.01; },
       Mark::unknown, true,
       "lambert has a median error (fitted) of 2 %; lack of fit cannot be judged, because symmetric rows "
       "differ "
       "(3.2 %), by noise or because the sample is not isotropic."},
      {"interpolated", [](FormFit& f) { f.about.interpolated = true; }, Mark::unknown, true,
       "was estimated on an interpolated grid"},
      {"misfit, scatter unknown",
       [](FormFit& f) { f.verdict = Verdict::misfit, f.lack_of_fit.residual_over_scatter.reset(); },
       Mark::bad, false, "lambert does not fit the measurements: median error (fitted) 2 %."},
      {"interpolates", [](FormFit& f) { f.about.held_out = HeldOut::interpolation; }, Mark::warn, true,
       "describes interpolation only, not the prediction of other incidences"},
      {"few_lights", [](FormFit& f) { f.about.held_out = HeldOut::few, f.about.lights = 3; }, Mark::warn,
       true, "rest on only 3 incidences"},
      {"breaks_energy",
       [](FormFit& f) {
         f.verdict = Verdict::breaks_energy;
         f.largest_measured_albedo = f.largest_albedo = LargestAlbedo{3.68, 0, "f"};
       },
       Mark::bad, false, "its directional albedo is 368 % at 0 degrees"},
      {"breaks_energy_elsewhere",
       [](FormFit& f) {
         f.largest_albedo = LargestAlbedo{2.04, 85, "f"};
       },
       Mark::warn, true, "at 85 degrees, without measurements nearby, the directional albedo would be 204 %"},
      {"at_bound", verdict(Verdict::at_bound), Mark::warn, true, "a parameter is at a bound of its range"},
      {"determined", verdict(Verdict::determined), Mark::warn, true, "some parameters are not identifiable"},
      {"not_identifiable", verdict(Verdict::not_identifiable), Mark::bad, false,
       "lambert is not identifiable from these measurements."},
      {"hidden_highlight", [](FormFit& f) { f.about.hidden_width = 0.03; }, Mark::warn, true,
       "a highlight narrower than alpha 0.03 (5.7 degrees wide) would lie between the measured directions"},
      {"few_rows_decide", [](FormFit& f) { f.few_rows_decide = "2 rows decide rho"; }, Mark::warn, true,
       "2 rows decide rho"},
      {"weakly_determined", [](FormFit& f) { f.estimates[0].low = 0.01, f.estimates[0].high = 2; },
       Mark::warn, true, "weakly determined: rho"},
      {"approximate", [](FormFit& f) { f.intervals = IntervalsBy::curvature; }, Mark::good, true,
       "the intervals are approximate"},
      {"diverged", verdict(Verdict::diverged), Mark::bad, false, "lambert could not be fitted."},
      {"interrupted", verdict(Verdict::interrupted), Mark::bad, false,
       "Interrupted: the best parameters of lambert so far."},
  };
}

TEST(States, EveryRowHasOneSentenceOneMarkAndOneExitCodeOnEveryFace) {
  const io::SampleTable table = measured(make_material(*find_form("lambert"), {"f"}), {"hemisphere"}, 0.02);
  std::set<Condition> reached;
  for (const Row& row : rows()) {
    FitResult result = good();
    FormFit& f = result.ranking.front();
    row.spoil(f);
    for (const Condition condition : conditions_of(f)) {
      reached.insert(condition);
      EXPECT_TRUE(state_of(condition).usable || !row.usable) << row.name;
    }
    EXPECT_EQ(mark_of(f), row.mark) << row.name;
    EXPECT_EQ(usable(f.verdict), row.usable) << row.name;
    std::ostringstream text;
    print(text, result, table, {}, {0, true});
    EXPECT_THAT(text.str(), HasSubstr(row.sentence)) << row.name;
    const char* const colour = row.mark == io::Mark::good      ? "\x1b[32m"
                               : row.mark == io::Mark::warn    ? "\x1b[33m"
                               : row.mark == io::Mark::unknown ? "\x1b[90m"
                                                               : "\x1b[31m";
    EXPECT_THAT(text.str(), HasSubstr(colour + verdict_sentence(f))) << row.name;
    const io::Json json = to_json(result, table, {})["ranking"][0];
    EXPECT_EQ(json["state"], std::string(name_of(row.mark))) << row.name;
    EXPECT_EQ(json["sentence"], verdict_sentence(f)) << row.name;
    const std::string page = html_report(result, table, {}, false);
    EXPECT_THAT(page, HasSubstr("verdict " + std::string(name_of(row.mark)))) << row.name;
    std::string on_page = row.sentence;
    if (on_page == "weakly determined: rho") on_page = "Weakly determined: rho";
    if (on_page.starts_with("a ") || on_page.starts_with("at ")) on_page[0] = char(std::toupper(on_page[0]));
    if (on_page == "the intervals are approximate") on_page = "The intervals are approximate";
    if (row.name == std::string("at_bound")) on_page = row.sentence;
    EXPECT_THAT(page, HasSubstr(on_page)) << row.name;
  }
  EXPECT_EQ(reached.size(), kNames<Condition>.size());
}

// The sentence of a spoilt fit must not appear for a good one. A spoilt fit must never be described as
// accurate to the measurement noise.
TEST(States, NoSentenceAppearsWithoutItsCondition) {
  const io::SampleTable table = measured(make_material(*find_form("lambert"), {"f"}), {"hemisphere"}, 0.02);
  const auto printed = [&](const FitResult& result) {
    std::ostringstream text;
    print(text, result, table, {}, {0, false});
    return text.str();
  };
  const std::string of_good = printed(good());
  for (const Row& row : rows()) {
    if (row.name == std::string("describes")) continue;
    EXPECT_THAT(of_good, testing::Not(HasSubstr(row.sentence))) << row.name;
    FitResult result = good();
    row.spoil(result.ranking.front());
    const Condition headline = conditions_of(result.ranking.front()).front();
    if (headline == Condition::describes) continue;
    EXPECT_THAT(printed(result), testing::Not(HasSubstr("consistent with the measurement noise")))
        << row.name;
    EXPECT_THAT(html_report(result, table, {}, false),
                testing::Not(HasSubstr("consistent with the measurement noise")))
        << row.name;
  }
}

TEST(States, ARefusedStepThatWouldHalveTheErrorSaysSo) {
  Step step{"a lobe", "ward", 0.27, 0.24, 0.1, 0.3, 5, false};
  EXPECT_THAT(in_words(step), testing::Not(HasSubstr("halve")));
  step.difference = 0.28;
  EXPECT_THAT(in_words(step), HasSubstr("not kept: it would halve the error"));
  step.kept = true;
  EXPECT_THAT(in_words(step), testing::Not(HasSubstr("halve")));
}

TEST(States, AFormTenTimesWorseThanTheFirstIsGrey) {
  FitResult result = good();
  FormFit first = result.ranking.front(), worse = first;
  first.left_out->errors.median = 0.01;
  worse.left_out->errors.median = 0.09;
  EXPECT_EQ(mark_in_ranking(worse, first), io::Mark::good);
  worse.left_out->errors.median = 0.11;
  EXPECT_EQ(mark_in_ranking(worse, first), io::Mark::unknown);
}

TEST(States, ANarrowTerminalKeepsTheScatterAndSaysWhatIsMissing) {
  const io::SampleTable table = measured(make_material(*find_form("lambert"), {"f"}), {"hemisphere"}, 0.02);
  for (const int columns : {0, 120, 80, 64}) {
    std::ostringstream text;
    print(text, good(), table, {}, {columns, false});
    EXPECT_THAT(text.str(), HasSubstr("x scatter")) << columns;
    const bool whole = text.str().find("off by 2  ") != std::string::npos;
    EXPECT_EQ(whole, text.str().find(", shows ") == std::string::npos) << columns;
  }
}

}  // namespace
}  // namespace brdf::fit
