// Tests parameters with one value for all channels, and weights that conserve energy.
#include <cmath>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "samples.h"

namespace brdf::fit {
namespace {

using testing::Contains;
using testing::HasSubstr;

Material paint(std::vector<std::vector<double>> weights, double alpha = 0.15) {
  Material m = make_material(*find_form("cook_torrance"));
  m.terms[0].shape[0] = {alpha, alpha};
  m.terms[0].weights = std::move(weights);
  return m;
}

FitOptions tying(std::vector<std::string> names) {
  FitOptions options;
  options.tie = std::move(names);
  options.cross_validation = false;
  return options;
}

TEST(Tie, WithoutNoiseWhatIsSharedIsRecoveredUnderEveryMetric) {
  const Material truth = paint({{0.3, 0.4, 0.06}, {0.2, 0.5, 0.06}, {0.1, 0.7, 0.06}});
  for (const Metric metric : {Metric::log, Metric::cosine_l2, Metric::log_relative}) {
    FitOptions options = tying({"f0"});
    options.metric = metric;
    const FormFit f = fit_one(measured(truth), {"cook_torrance"}, options);
    EXPECT_EQ(f.verdict, Verdict::converged);
    EXPECT_EQ(f.parameters, 8u);  // alpha, kd and ks of three channels, f0
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_LT(largest_relative_difference(f.material.terms[0].weights[c], truth.terms[0].weights[c]), 1e-6);
      EXPECT_EQ(f.material.terms[0].weights[c][2], f.material.terms[0].weights[0][2]);
    }
    ASSERT_NE(find_estimate(f, "f0", ""), nullptr);  // once, without a channel
    EXPECT_EQ(find_estimate(f, "f0", "r"), nullptr);
    EXPECT_NE(find_estimate(f, "ks", "r"), nullptr);
  }
}

TEST(Tie, OfAnyWeightOrSeveral) {
  const Material metal = paint({{0.02, 0.8, 0.9}, {0.02, 0.8, 0.6}, {0.02, 0.8, 0.4}});
  for (const auto& [names, parameters] :
       {std::pair{std::vector<std::string>{"ks"}, 8u}, {{"kd"}, 8u}, {{"kd", "ks"}, 6u}}) {
    const FormFit f = fit_one(measured(metal), {"cook_torrance"}, tying(names));
    EXPECT_EQ(f.parameters, parameters);
    for (std::size_t c = 0; c < 3; ++c)
      EXPECT_LT(largest_relative_difference(f.material.terms[0].weights[c], metal.terms[0].weights[c]), 1e-6);
  }
  const Material grey = paint({{0.3, 0.4, 0.06}, {0.3, 0.4, 0.06}, {0.3, 0.4, 0.06}});
  const FormFit f = fit_one(measured(grey), {"cook_torrance"}, tying({"kd", "ks", "f0"}));
  EXPECT_EQ(f.parameters, 4u);
  EXPECT_LT(largest_relative_difference(f.material.terms[0].weights[1], grey.terms[0].weights[1]), 1e-6);
}

// Three channels that share one f0 determine it more precisely than one channel alone.
TEST(Tie, NarrowsTheIntervalOfWhatIsShared) {
  const Material truth = paint({{0.2, 0.6, 0.06}, {0.2, 0.6, 0.06}, {0.2, 0.6, 0.06}});
  const io::SampleTable table = measured(truth, {"hemisphere"}, 0.02);
  FitOptions options = tying({});
  options.metric = Metric::log_relative;  // the noise is uniform under this metric
  const FormFit own = fit_one(table, {"cook_torrance"}, options);
  options.tie = {"f0"};
  const FormFit tied = fit_one(table, {"cook_torrance"}, options);
  ASSERT_NE(find_estimate(tied, "f0", ""), nullptr);
  ASSERT_EQ(find_estimate(tied, "f0", "")->status, Status::free);
  const double width = find_estimate(tied, "f0", "")->standard_error;
  for (const char* channel : {"r", "g", "b"})
    EXPECT_LT(width, 0.75 * find_estimate(own, "f0", channel)->standard_error) << channel;
  EXPECT_LT(std::abs(find_estimate(tied, "f0", "")->value - 0.06), 3 * width);
}

TEST(Tie, OfAShapeLeavesTheOthersToTheChannels) {
  Material truth = make_material(*find_form("oren_nayar"));
  truth.terms.push_back(make_term(*find_form("ward"), 3));
  truth.terms[0].shape = {{0.2}, {0.4}, {0.6}};
  truth.terms[1].shape = {{0.1, 0.1}, {0.1, 0.1}, {0.1, 0.1}};
  for (std::size_t c = 0; c < 3; ++c) {
    truth.terms[0].weights[c] = {0.4};
    truth.terms[1].weights[c] = {0, 0.2};
  }
  FitOptions options = tying({"alpha"});
  options.per_channel = true;
  const FormFit f = fit_one(measured(truth), {"oren_nayar", "ward"}, options);
  EXPECT_EQ(f.parameters, 3u + 1 + 6);
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_NEAR(f.material.terms[0].shape[c][0], truth.terms[0].shape[c][0], 1e-6);
    EXPECT_NEAR(f.material.terms[1].shape[c][0], 0.1, 1e-7);
  }
  ASSERT_NE(find_estimate(f, "terms[1].alpha_x", ""), nullptr);
  EXPECT_EQ(find_estimate(f, "terms[1].alpha_y", "")->status, Status::free);
  EXPECT_EQ(find_estimate(f, "terms[1].alpha_x", "r"), nullptr);
  EXPECT_NE(find_estimate(f, "terms[0].sigma", "g"), nullptr);
}

// If the two lobes of a sum are exchanged, the parameters that their channels share must be exchanged with
// them.
TEST(Tie, InASumOfEqualFormsTheNarrowLobeComesFirst) {
  Material truth = paint({{0.2, 0.5, 0.1}, {0.2, 0.3, 0.1}, {0.2, 0.1, 0.1}}, 0.06);
  truth.terms.push_back(truth.terms[0]);
  truth.terms[1].shape[0] = {0.4, 0.4};
  for (std::size_t c = 0; c < 3; ++c) truth.terms[1].weights[c] = {0, 0.4, 0.3};
  const FormFit f =
      fit_one(measured(truth, {"hemisphere", "in_plane"}), {"cook_torrance", "cook_torrance"}, tying({"f0"}));
  EXPECT_EQ(f.parameters, 2u + 3 + 6 + 2);
  for (std::size_t t = 0; t < 2; ++t) {
    EXPECT_NEAR(f.material.terms[t].shape[0][0], truth.terms[t].shape[0][0], 1e-5);
    for (std::size_t c = 0; c < 3; ++c)
      for (std::size_t k = 0; k < 3; ++k)
        EXPECT_NEAR(f.material.terms[t].weights[c][k], truth.terms[t].weights[c][k], 1e-4);
  }
  for (const std::string& finding : f.findings) EXPECT_THAT(finding, testing::Not(HasSubstr("same cost")));
}

TEST(Tie, WithoutEffectIsRefused) {
  EXPECT_THAT(refusal({"cook_torrance"}, tying({"f0"}), {"f"}),
              HasSubstr("--tie f0: has no effect: the samples have one channel"));
  EXPECT_THAT(refusal({"ward"}, tying({"f0"})), HasSubstr("--tie f0: ward has no parameter of this name"));
  EXPECT_THAT(refusal({"ward"}, tying({"alpha"})),
              HasSubstr("--tie alpha: has an effect only with --per-channel"));
  EXPECT_THAT(refusal({"ward"}, tying({"ks", "ks"})), HasSubstr("--tie ks: is given twice"));
  FitOptions options = tying({"ks"});
  options.fix = {{"ks", {0.3}}};
  EXPECT_THAT(refusal({"ward"}, options),
              HasSubstr("--tie ks: has no effect, because --fix holds this parameter"));
  options = tying({"ks"});
  options.start = {{"ks", {0.1, 0.2, 0.3}}};
  EXPECT_THAT(refusal({"ward"}, options), HasSubstr("--start ks: takes a single value with --tie"));
  EXPECT_EQ(refusal({"oren_nayar", "cook_torrance"}, tying({"f0"})), "");
}

FitOptions physical(Physical p = Physical::either) {
  FitOptions options;
  options.physical = p;
  options.cross_validation = false;
  return options;
}

TEST(PhysicalWeights, KeepTheirSumWithinOne) {
  Material bright = make_material(*find_form("ward"));
  bright.terms[0].shape[0] = {0.2, 0.2};
  bright.terms[0].weights = {{0.8, 0.6}, {0.5, 0.3}, {0.9, 0.02}};
  const io::SampleTable table = measured(bright);
  const FormFit f = fit_one(table, {"ward"}, physical());
  const auto& w = f.material.terms[0].weights;
  EXPECT_NEAR(w[0][0] + w[0][1], 1, 1e-9);
  EXPECT_LE(w[0][0] + w[0][1], 1 + 1e-12);
  EXPECT_GT(w[1][0] + w[1][1], 0.7);
  EXPECT_LT(w[1][0] + w[1][1], 0.9);
  EXPECT_EQ(f.verdict == Verdict::at_bound || f.verdict == Verdict::misfit, true);
  EXPECT_THAT(f.findings, Contains(HasSubstr("kd + ks is at its bound 1 in r")));
  // The result is the best of all permitted points: moving along the bound in either direction raises the
  // cost.
  FitOptions held = physical();
  held.fix = {{"kd", {w[0][0] + 0.01, w[1][0], w[2][0]}}};
  EXPECT_GT(fit_one(table, {"ward"}, held).minima[0].cost, f.minima[0].cost);
  held.fix[0].values[0] -= 0.02;
  EXPECT_GT(fit_one(table, {"ward"}, held).minima[0].cost, f.minima[0].cost);
}

TEST(PhysicalWeights, ThatAreNotAtTheirBoundsAreThoseWithoutThem) {
  Material truth = make_material(*find_form("ward"));
  truth.terms[0].shape[0] = {0.2, 0.2};
  truth.terms[0].weights = {{0.4, 0.3}, {0.5, 0.3}, {0.6, 0.1}};
  const io::SampleTable table = measured(truth, {"hemisphere"}, 0.03);
  FitOptions free = physical(Physical::off);
  const FormFit a = fit_one(table, {"ward"}, free), b = fit_one(table, {"ward"}, physical());
  EXPECT_EQ(b.verdict, Verdict::converged);
  for (std::size_t c = 0; c < 3; ++c)
    EXPECT_LT(largest_relative_difference(b.material.terms[0].weights[c], a.material.terms[0].weights[c]),
              1e-5);
  for (std::size_t k = 0; k < a.estimates.size(); ++k)
    EXPECT_NEAR(a.estimates[k].standard_error, b.estimates[k].standard_error,
                1e-3 * a.estimates[k].standard_error)
        << a.estimates[k].name;
}

TEST(PhysicalWeights, OfADielectricHaveAWholeLobe) {
  const Material truth = paint({{0.6, 1, 0.05}, {0.3, 1, 0.05}, {0.1, 1, 0.05}});
  const FormFit f = fit_one(measured(truth, {"hemisphere"}, 0.02), {"cook_torrance"}, physical());
  EXPECT_THAT(f.findings, Contains(HasSubstr("the material is assumed to be a dielectric")));
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_EQ(f.material.terms[0].weights[c][1], 1);
    EXPECT_NEAR(f.material.terms[0].weights[c][0], truth.terms[0].weights[c][0], 0.02);
    EXPECT_NEAR(f.material.terms[0].weights[c][2], 0.05, 0.005);
  }
  EXPECT_EQ(f.verdict, Verdict::converged);
  EXPECT_EQ(find_estimate(f, "ks", "r")->status, Status::fixed);
}

TEST(PhysicalWeights, OfWhatIsNoDielectricAddUpToLessThanOne) {
  const Material truth = paint({{0.3, 0.5, 0.5}, {0.2, 0.5, 0.5}, {0.1, 0.5, 0.5}}, 0.3);
  const FormFit f = fit_one(measured(truth, {"hemisphere"}, 0.02), {"cook_torrance"}, physical());
  EXPECT_THAT(f.findings, Contains(HasSubstr("the material is not assumed to be a dielectric")));
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(f.material.terms[0].weights[c][1], 0.5, 0.05);
}

// The part that a held kd takes is not available to f0: the largest f0 is 1 minus the held kd.
TEST(PhysicalWeights, OfADielectricLeaveF0WhatIsHeld) {
  const Material metal = paint({{0.3, 1, 0.9}, {0.3, 1, 0.9}, {0.3, 1, 0.9}});
  FitOptions options = physical(Physical::dielectric);
  options.fix = {{"kd", {0.3, 0.05, 0}}};
  const FormFit f = fit_one(measured(metal), {"cook_torrance"}, options);
  EXPECT_DOUBLE_EQ(f.material.terms[0].weights[0][2], 0.7);
  EXPECT_EQ(find_estimate(f, "f0", "r")->status, Status::at_bound);
  EXPECT_NEAR(f.material.terms[0].weights[1][2], 0.95, 0.06);
  EXPECT_LE(f.material.terms[0].weights[1][2], 0.95);
}

TEST(PhysicalWeights, AndSharedOnes) {
  Material truth = make_material(*find_form("ward"));
  truth.terms[0].shape[0] = {0.2, 0.2};
  truth.terms[0].weights = {{0.4, 0.3}, {0.5, 0.3}, {0.2, 0.3}};
  FitOptions options = physical();
  options.tie = {"ks"};
  const FormFit f = fit_one(measured(truth), {"ward"}, options);
  for (std::size_t c = 0; c < 3; ++c)
    EXPECT_LT(largest_relative_difference(f.material.terms[0].weights[c], truth.terms[0].weights[c]), 1e-6);
}

TEST(PhysicalWeights, ThatCannotBeAreRefused) {
  FitOptions options = physical(Physical::bounded);
  options.fix = {{"kd", {0.8}}, {"ks", {0.4}}};
  EXPECT_THAT(refusal({"ward"}, options), HasSubstr("add up to 1.2"));
  options.fix = {{"kd", {1}}};
  EXPECT_THAT(refusal({"ward"}, options), HasSubstr("leave no room for ks"));
  options.fix.clear();
  options.bounds = {{"ks", 0.1, 0.2}};
  EXPECT_THAT(refusal({"ward"}, options), HasSubstr("--bounds ks: cannot be used with --physical"));
  options.fix = {{"kd", {0.5}}};
  EXPECT_EQ(refusal({"ward"}, options), "");
}

}  // namespace
}  // namespace brdf::fit
