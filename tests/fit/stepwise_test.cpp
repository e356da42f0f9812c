// Tests that --form auto keeps as many terms as the samples support.

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <numeric>
#include <vector>

#include "brdf/random.h"
#include "samples.h"

namespace brdf::fit {
namespace {

Material one_lobe(double kd, double ks, double f0, double alpha) {
  Material m = make_material(*find_form("cook_torrance"), {"f"});
  m.terms[0].shape[0] = {alpha, alpha};
  m.terms[0].weights = {{kd, ks, f0}};
  return m;
}

Material two_lobes(double narrow, double wide) {
  Material m = one_lobe(0.2, 0.3, 0.3, narrow);
  m.terms.push_back(one_lobe(0, 0.5, 0.3, wide).terms[0]);
  return m;
}

const Step& last_kept(const FitResult& result) {
  return *std::find_if(result.steps.rbegin(), result.steps.rend(), [](const Step& s) { return s.kept; });
}

// An interruption is no lack of directions.
TEST(Stepwise, ReportsAnInterruption) {
  std::atomic<bool> stop = true;
  FitOptions options;
  options.interrupted = &stop;
  const FitResult result = fit(fine_hemisphere(one_lobe(0.3, 0.5, 0.04, 0.2), 0.03, 1), {}, options);
  EXPECT_TRUE(result.interrupted);
  EXPECT_FALSE(result.ranking.empty());
}

TEST(Stepwise, MattSamplesKeepADiffuseTerm) {
  Material matt = make_material(*find_form("lambert"), {"f"});
  matt.terms[0].weights = {{0.5}};
  const FitResult result = fit(fine_hemisphere(matt, 0.03, 1), {}, {});
  EXPECT_EQ(result.ranking.front().form, "lambert");
  ASSERT_EQ(result.steps.size(), 3u);
  EXPECT_FALSE(result.steps[1].kept);
  EXPECT_FALSE(result.steps[2].kept);
}

TEST(Stepwise, ARoughMattSurfaceAsksForADiffuseTermWithAShape) {
  Material rough = make_material(*find_form("oren_nayar"), {"f"});
  rough.terms[0].shape[0] = {0.42};
  rough.terms[0].weights = {{0.6}};
  const FitResult result = fit(fine_hemisphere(rough, 0.03, 2), {}, {});
  EXPECT_TRUE(result.ranking.front().form.starts_with("oren_nayar")) << result.ranking.front().form;
  EXPECT_TRUE(std::ranges::any_of(
      result.steps, [](const Step& s) { return s.kept && s.added == "a diffuse term with a shape"; }));
}

TEST(Stepwise, OneLobeStaysOne) {
  const FitResult result = fit(fine_hemisphere(one_lobe(0.3, 0.5, 0.2, 0.25), 0.02, 2), {}, {});
  EXPECT_EQ(result.ranking.front().form, "cook_torrance");
  ASSERT_EQ(result.steps.size(), 4u);
  EXPECT_TRUE(result.steps[1].kept);
  EXPECT_LT(result.steps[1].p, 0.05);
  EXPECT_FALSE(result.steps[2].kept);
  EXPECT_FALSE(result.steps[3].kept);
}

TEST(Stepwise, ASecondLobeIsFoundAndWhatItBoughtIsSaid) {
  const FitResult result = fit(fine_hemisphere(two_lobes(0.08, 0.4), 0.02, 3), {}, {});
  const Step& step = last_kept(result);
  EXPECT_EQ(step.added, "a second lobe");
  EXPECT_EQ(step.model, result.ranking.front().form);
  EXPECT_EQ(result.ranking.front().material.terms.size(), 2u);
  EXPECT_GT(step.difference, step.standard_error);
  EXPECT_LT(step.left_out, result.steps[1].left_out);
}

TEST(Stepwise, ATailOfItsOwnIsPreferredWhereItIsSeen) {
  Material m = make_material(*find_form("cook_torrance_student"), {"f"});
  m.terms[0].shape[0] = {0.3, 0.3, 6};
  m.terms[0].weights = {{0.02, 0.8, 0.4}};
  const FormFit best = fit(fine_hemisphere(m, 0.02, 4), {}, {}).ranking.front();
  ASSERT_EQ(best.form, "cook_torrance_student");
  EXPECT_NEAR(best.material.terms[0].shape[0][2], 6, 1);
}

TEST(Stepwise, TheOrderOfRowsDecidesNothing) {
  io::SampleTable table = fine_hemisphere(two_lobes(0.1, 0.5), 0.03, 5);
  const FitResult ordered = fit(table, {}, {});
  std::vector<std::size_t> order(table.rows());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::shuffle(order.begin(), order.end(), std::mt19937_64(9));
  io::SampleTable shuffled = table;
  for (std::size_t k = 0; k < order.size(); ++k) {
    for (auto column : {&io::SampleTable::theta_i, &io::SampleTable::phi_i, &io::SampleTable::theta_o,
                        &io::SampleTable::phi_o})
      (shuffled.*column)[k] = (table.*column)[order[k]];
    for (std::size_t c = 0; c < table.values.size(); ++c) shuffled.values[c][k] = table.values[c][order[k]];
  }
  const FitResult again = fit(shuffled, {}, {});
  ASSERT_EQ(again.steps.size(), ordered.steps.size());
  for (std::size_t k = 0; k < again.steps.size(); ++k) {
    EXPECT_EQ(again.steps[k].model, ordered.steps[k].model);
    EXPECT_EQ(again.steps[k].left_out, ordered.steps[k].left_out);
    EXPECT_EQ(again.steps[k].p, ordered.steps[k].p);
  }
  EXPECT_EQ(again.ranking.front().material.terms[0].shape, ordered.ranking.front().material.terms[0].shape);
}

}  // namespace
}  // namespace brdf::fit
