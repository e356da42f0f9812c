// Tests results of a fit other than the parameters, through the executable: weights that are shared or
// conserve energy, and the uncertainty of values that are computed from a fitted material.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "io/files/json.h"
#include "io/files/output.h"
#include "tests/cli/run_brdf.h"

namespace brdf {
namespace {

using testing::HasSubstr;
using testing::Not;

io::Json json_of(const Outcome& outcome) {
  return io::Json::parse(outcome.out);
}

class Fitted : public ::testing::Test {
 protected:
  // Measures paint in three channels over a hemisphere with 2 % noise.
  void SetUp() override {
    ASSERT_EQ(run("synth --form cook_torrance --set kd=0.5,0.3,0.2 --set ks=1 --set f0=0.05 --set alpha=0.2 "
                  "--theta-i 10,30,50,70 --step 10 --noise 0.02 -o paint.csv")
                  .exit_code,
              0);
  }
  Outcome run(const std::string& arguments) { return run_brdf(arguments, folder_.path()); }
  io::TemporaryFolder folder_;
};

TEST_F(Fitted, MaterialsGiveTheirAlbedoWithAnInterval) {
  ASSERT_EQ(run("fit paint.csv --form cook_torrance -o paint.json --report paint.html").exit_code, 0);
  const io::Json rows = json_of(run("albedo --material paint.json --theta 0,60 --json"))["results"];
  const io::Json truth =
      json_of(run("albedo --form cook_torrance --set kd=0.5,0.3,0.2 --set ks=1 --set f0=0.05 "
                  "--set alpha=0.2 --theta 0,60 --json"))["results"];
  ASSERT_EQ(rows.size(), 6u);
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const double low = rows[k]["low"], high = rows[k]["high"], value = rows[k]["value"];
    EXPECT_LT(low, value);
    EXPECT_GT(high, value);
    EXPECT_LT(high - low, 0.1 * value);
    EXPECT_GT(high - low, 1e-3 * value);
    EXPECT_NEAR(truth[k]["value"], value, high - low);  // four standard errors
  }
  EXPECT_THAT(run("albedo --material paint.json --theta 0").out, HasSubstr("95 % interval of the fit"));
  // A changed material and a material that was never fitted have no interval.
  EXPECT_THAT(run("albedo --material paint.json --set kd=0.1 --theta 0").out, Not(HasSubstr("interval")));
  EXPECT_FALSE(truth[0].contains("low"));
  EXPECT_THAT(file_text(folder_.path() / "paint.html"), HasSubstr("Bands: 95 % confidence bands of the fit"));
}

TEST_F(Fitted, ABudgetIsInEveryNumberThatFollows) {
  io::write_file_atomically(folder_.path() / "budget.csv",
                            "source,standard_uncertainty,unit,shared_by\n"
                            "reference_standard,0.03,relative,table\n");
  ASSERT_EQ(run("fit paint.csv --form cook_torrance --budget budget.csv -o certain.json").exit_code, 0);
  ASSERT_EQ(run("fit paint.csv --form cook_torrance -o plain.json").exit_code, 0);
  const io::Json row = json_of(run("albedo certain.json --theta 30 --json"))["results"][0],
                 plain = json_of(run("albedo plain.json --theta 30 --json"))["results"][0];
  EXPECT_EQ(row["interval_contains"], "scatter and budget");
  EXPECT_EQ(plain["interval_contains"], "scatter");
  EXPECT_FALSE(plain.contains("standard_uncertainty"));
  // The scale of the standard moves the albedo as a whole; the scatter of many rows adds little.
  EXPECT_NEAR(row["standard_uncertainty"].get<double>() / row["value"].get<double>(), 0.03, 1e-4);
  EXPECT_THAT(run("albedo plain.json --theta 30").out, HasSubstr("intervals: scatter only"));
  EXPECT_THAT(run("albedo certain.json --theta 30").out, HasSubstr("reference_standard 100 %"));
  io::write_file_atomically(folder_.path() / "d.csv", "theta_i,phi_i,theta_o,phi_o\n0,0,45,0\n");
  const std::string values = run("eval certain.json --sigma-columns d.csv").out;
  EXPECT_THAT(values, HasSubstr("# standard uncertainties: with the budget of the fit\n"));
  EXPECT_THAT(values, HasSubstr("sigma_f_r"));
  EXPECT_THAT(run("eval plain.json --sigma-columns d.csv").out,
              HasSubstr("# standard uncertainties: scatter only"));
  const Outcome none = run("eval --form ward --sigma-columns d.csv");
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_THAT(none.err, HasSubstr("holds no covariance"));
  const Outcome bad = run("fit paint.csv --form ward --budget d.csv");
  EXPECT_EQ(bad.exit_code, 2);
  EXPECT_THAT(bad.err, HasSubstr("d.csv, line 1: a budget needs the column source"));
}

TEST_F(Fitted, WeightsMayBeSharedAndPhysical) {
  const io::Json tied = json_of(run("fit paint.csv --form cook_torrance --tie f0 --json"))["ranking"][0];
  EXPECT_EQ(tied["parameters"], 8);
  EXPECT_TRUE(tied["intervals"]["f0"].contains("status"));  // one for all channels
  const io::Json f0 = tied["material"]["weights"]["f0"];
  if (f0.is_array()) {
    EXPECT_EQ(f0[0], f0[1]);
    EXPECT_EQ(f0[0], f0[2]);
  }
  const io::Json physical =
      json_of(run("fit paint.csv --form cook_torrance --physical --json"))["ranking"][0];
  EXPECT_EQ(physical["intervals"]["ks"]["r"]["status"], "fixed");
  EXPECT_EQ(physical["intervals"]["ks"]["r"]["value"], 1);
  EXPECT_NEAR(physical["intervals"]["f0"]["r"]["value"], 0.05, 0.005);
  const Outcome refused = run("fit paint.csv --form ward --tie f0");
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.err, HasSubstr("--tie f0: ward has no parameter of this name"));
}

TEST_F(Fitted, MaterialsThatBreakEnergySayTheNumber) {
  ASSERT_EQ(run("synth --form ward --set kd=0.8 --set ks=0.6 --set alpha=0.2 -o bright.csv").exit_code, 0);
  const Outcome fit = run("fit bright.csv --form ward");
  EXPECT_EQ(fit.exit_code, 1);
  EXPECT_THAT(
      fit.out,
      HasSubstr("ward violates energy conservation: its directional albedo is 133.7 % at 0 degrees."));
  EXPECT_THAT(fit.out, HasSubstr("with --physical the median error is"));
  const io::Json largest =
      json_of(run("fit bright.csv --form ward --json"))["ranking"][0]["largest_measured_albedo"];
  const io::Json albedo =
      json_of(run("albedo --form ward --set kd=0.8 --set ks=0.6 --set alpha=0.2 --theta 0 --json"));
  EXPECT_NEAR(largest["value"], albedo["results"][0]["value"], 2e-3);
}

}  // namespace
}  // namespace brdf
