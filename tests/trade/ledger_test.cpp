// Tests the ledger of costs and errors: dominated rows, files, comparisons and conclusions.
#include "trade/ledger/ledger.h"
#include "trade/ledger/compare.h"
#include "trade/ledger/conclusion.h"
#include "trade/ledger/report.h"

#include <gtest/gtest.h>

#include "io/files/error.h"

namespace brdf::trade {
namespace {

LedgerRow row(const char* choice, double seconds, double max, double mean) {
  LedgerRow r;
  r.question = "q";
  r.choice = choice;
  r.exact = "exact";
  r.cost = {seconds, 0.01, 21};
  r.cost_ratio = seconds;
  r.error = {max, mean, max, Measure::relative, "x 1"};
  return r;
}

TEST(Ledger, NamesWhatIsNeitherFasterNorMoreAccurate) {
  std::vector<LedgerRow> rows{row("exact", 1, 0, 0), row("fast", 0.2, 0.1, 0.01),
                              row("naive", 1.2, 0.3, 0.1)};
  mark_dominated(rows);
  EXPECT_EQ(rows[0].dominated_by, "");
  EXPECT_EQ(rows[1].dominated_by, "");
  EXPECT_EQ(rows[2].dominated_by, "fast");  // the cheapest row that dominates it
}

TEST(Ledger, DifferencesOfCostWithinTheNoiseDecideNothing) {
  std::vector<LedgerRow> rows{row("a", 1.00, 0.1, 0.1), row("b", 1.04, 0.1, 0.1)};
  mark_dominated(rows);
  EXPECT_EQ(rows[0].dominated_by, "");
  EXPECT_EQ(rows[1].dominated_by, "");
  rows[1].error.max = 0.05;  // not measurably more expensive, and more accurate
  mark_dominated(rows);
  EXPECT_EQ(rows[0].dominated_by, "b");
}

TEST(Ledger, ALowerMeanDoesNotDominateALowerMaximum) {
  std::vector<LedgerRow> rows{row("a", 1, 0.2, 0.01), row("b", 1, 0.1, 0.02)};
  mark_dominated(rows);
  EXPECT_EQ(rows[0].dominated_by, "");
  EXPECT_EQ(rows[1].dominated_by, "");
}

TEST(Ledger, QuestionsDoNotMix) {
  std::vector<LedgerRow> rows{row("a", 1, 0, 0), row("b", 2, 1, 1)};
  rows[1].question = "another";
  mark_dominated(rows);
  EXPECT_EQ(rows[1].dominated_by, "");
}

TEST(Ledger, ReadsBackWhatItWrote) {
  Ledger ledger;
  ledger.machine = this_machine();
  ledger.rows = {row("exact", 1e-9, 0, 0), row("fast", 2e-10, 0.1, 0.01)};
  ledger.rows[1].image_error = 0.25;
  ledger.rows[1].extremes = {{"alpha 0.0001", 1e30}};
  ledger.rows[1].unit = Unit::albedo;
  ledger.claims = {{"a", "b", Standing::on_condition, "c", "d", "q", "fast"}};
  const io::Json json = to_json(ledger);
  const Ledger back = ledger_from_json(io::JsonPlace(json, "memory"));
  EXPECT_EQ(to_json(back).dump(), json.dump());
  ASSERT_NE(back.find("q", "fast"), nullptr);
  EXPECT_EQ(back.find("q", "fast")->unit, Unit::albedo);
  EXPECT_EQ(back.find("q", "nobody"), nullptr);
}

TEST(Ledger, CountsAreWholeNumbersInTheirRange) {
  Ledger ledger;
  ledger.machine = this_machine();
  ledger.rows = {row("exact", 1e-9, 0, 0)};
  const io::Json sound = to_json(ledger);
  EXPECT_NO_THROW(ledger_from_json(io::JsonPlace(sound, "l.json")));
  for (const double wrong : {1e300, -1.0, 0.5}) {
    io::Json rounds = sound, threads = sound;
    rounds["rows"][0]["rounds"] = wrong;
    threads["machine"]["threads"] = wrong;
    for (const auto& [json, place] :
         {std::pair{rounds, "$.rows[0].rounds"}, {threads, "$.machine.threads"}}) {
      try {
        ledger_from_json(io::JsonPlace(json, "l.json"));
        ADD_FAILURE() << place << " " << wrong << " is accepted";
      } catch (const InputError& error) {
        EXPECT_EQ(std::string(error.what()).find(std::string("l.json: ") + place), 0u) << error.what();
      }
    }
  }
}

TEST(Ledger, RefusesWhatIsNoLedger) {
  const io::Json json = {{"format", "brdf-material"}};
  EXPECT_THROW(ledger_from_json(io::JsonPlace(json, "m.json")), InputError);
}

TEST(Ledger, TableHasOneLinePerRow) {
  Ledger ledger;
  ledger.rows = {row("exact", 1, 0, 0), row("with \"quotes\"", 1, 0, 0)};
  const std::string csv = to_csv(ledger);
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 3);
  EXPECT_NE(csv.find("\"with \"\"quotes\"\"\""), std::string::npos);
}

TEST(Compare, CountsRowsWhoseCostRatiosAreFurtherApartThanAQuarter) {
  Ledger before, after;
  before.rows = {row("exact", 4e-9, 0, 0), row("same", 2e-9, 0, 0), row("other", 2e-9, 0, 0),
                 row("tiny", 1e-10, 0, 0), row("gone", 1, 0, 0)};
  after.rows = before.rows;
  after.rows.pop_back();
  after.rows[1].cost_ratio *= 1.24;
  after.rows[2].cost_ratio /= 1.26;  // both directions count alike
  after.rows[3].cost_ratio *= 10;    // below 1 ns
  const Comparison c = compare(before, after);
  EXPECT_EQ(c.compared.size(), 3u);
  EXPECT_EQ(c.compared[0].choice, "other");
  EXPECT_NEAR(c.compared[0].difference(), 0.26, 1e-12);
  EXPECT_EQ(c.apart(), 1u);
  EXPECT_EQ(c.shorter, 1u);
  EXPECT_EQ(c.missing, std::vector<std::string>{"q: gone"});
  EXPECT_EQ(compare(before, before).apart(), 0u);
  after.quick = true;
  EXPECT_THROW(compare(before, after), InputError);
}

TEST(Conclusion, IsTheCheapestThatIsAccurateEnough) {
  const std::vector<LedgerRow> rows{row("exact", 1, 0, 0), row("fine", 0.6, 1e-4, 1e-5),
                                    row("coarse", 0.2, 0.1, 0.009), row("wrong", 0.1, 0.5, 0.02)};
  const std::vector<const LedgerRow*> all{&rows[0], &rows[1], &rows[2], &rows[3]};
  EXPECT_EQ(cheapest_within(all, 1e-2), &rows[2]);
  EXPECT_EQ(cheapest_within(all, 1e-4), &rows[1]);
  EXPECT_EQ(cheapest_within(all, 1e-6), nullptr);
  EXPECT_EQ(
      conclusion(all),
      "The cheapest choice with a mean error below 0.01 is coarse at 0.2 of the exact cost (largest error "
      "0.1); below 0.0001 it is fine at 0.6 of the exact cost (largest error 0.0001).");
  EXPECT_EQ(conclusion({all[0], all[3]}), "No cheaper choice has a mean error below 0.01: use exact.");
}

TEST(Conclusion, ADifferenceWithinTheNoiseOrWithoutAMeasurementIsNoGain) {
  std::vector<LedgerRow> rows{row("exact", 1, 0, 0), row("same", 0.96, 0, 0), row("unmeasured", 0.1, 0, 0)};
  rows[2].cost.rounds = 0;
  EXPECT_EQ(cheapest_within({&rows[0], &rows[1], &rows[2]}, 1e-2), nullptr);
}

TEST(LedgerPage, ExactIsAWordAndTheFrontIsToldFromTheRest) {
  Ledger ledger;
  ledger.machine = this_machine();
  ledger.rows = {row("exact", 1, 1e-16, 1e-17), row("fast", 0.2, 0.1, 0.005), row("naive", 1.2, 0.3, 0.1)};
  mark_dominated(ledger.rows);
  const std::string html = to_html(ledger);
  EXPECT_NE(html.find("In 1 of 1 questions a cheaper choice has a mean error below 0.01"), std::string::npos);
  EXPECT_NE(html.find("\"bottom_edge\""), std::string::npos);
  EXPECT_EQ(html.find("1e-17"), std::string::npos);
  EXPECT_NE(html.find("<td class=\"good\">on the front</td>"), std::string::npos);
  EXPECT_NE(html.find("<td class=\"absent\">dominated<span class=\"note\">by fast</span></td>"),
            std::string::npos);
}

}  // namespace
}  // namespace brdf::trade
