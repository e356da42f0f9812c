// Tests that the residual with the most uniform noise on the data is chosen, and that the choice is
// reported.
#include "fit/assess/metric_choice.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "fit/fit.h"
#include "fit/report/report.h"
#include "io/samples/noise.h"
#include "tests/fit/samples.h"

namespace brdf::fit {
namespace {

// Returns measurements from 0.003 to 8 /sr, multiplied by `scale`. `share` is the noise relative to the
// value, `floor` its constant part.
io::SampleTable dark_gloss(double share, double floor, bool sigma = false, double scale = 1) {
  Material m = make_material(*find_form("cook_torrance"), {"f"});
  m.terms[0].shape[0] = {0.15, 0.15};
  m.terms[0].weights[0] = {0.01 * scale, 0.5 * scale, 0.5};
  synth::Instrument instrument;
  instrument.grid.theta_i = {10, 30, 45, 60, 70};
  instrument.noise = share;
  instrument.noise_floor = floor;
  instrument.sigma_columns = sigma;
  return synth::measure(m, instrument);
}

MetricChoice chosen(const io::SampleTable& table, Metric metric = Metric::automatic) {
  FitOptions options;
  options.metric = metric;
  const FitData data = prepare(table, options);
  return choose_metric(table, data, io::relative_noise(table, data.row).value, options);
}

double factor_of(const MetricChoice& choice, Metric metric) {
  for (const Unevenness& u : choice.unevenness)
    if (u.metric == metric) return u.factor;
  return kUnknown;
}

// In an even grid, a row stands for a patch of the size sin(theta_i) sin(theta_o).
TEST(Weights, OfSolidAngleWeighARowByBothSines) {
  io::SampleTable table;
  table.channels = {"f"};
  table.values.resize(1);
  double products = 0, squares = 0;
  for (const auto& [theta_i, theta_o, f] :
       {std::array{20.0, 70.0, 0.11}, {50.0, 35.0, 0.19}, {75.0, 10.0, 0.14}}) {
    table.add_directions(theta_i, 180, theta_o, 30);
    table.values[0].push_back(f);
    const double in = degrees(theta_i).radians(),
                 weight = std::sin(in) * std::sin(degrees(theta_o).radians());
    products += weight * square(std::cos(in)) * f;
    squares += weight * square(std::cos(in));
  }
  FitOptions options = without_cross_validation();
  options.metric = Metric::cosine_l2;
  options.weighting = Weighting::solid_angle;
  const FormFit weighted = fit(table, {{*find_form("lambert")}}, options).ranking[0];
  EXPECT_NEAR(find_estimate(weighted, "rho")->value, kPi * products / squares, 1e-9);
  options.weighting = Weighting::uniform;
  const FormFit uniform = fit(table, {{*find_form("lambert")}}, options).ranking[0];
  EXPECT_GT(std::abs(find_estimate(uniform, "rho")->value - kPi * products / squares), 0.01);
}

TEST(MetricChoice, NoiseThatIsAShareOfTheValueAsksForALogarithm) {
  const MetricChoice choice = chosen(dark_gloss(0.03, 0));
  EXPECT_EQ(choice.metric, Metric::log_relative);
  EXPECT_LT(factor_of(choice, Metric::log_relative), 1.6);
  EXPECT_GT(factor_of(choice, Metric::cosine_l2), 3);
}

TEST(MetricChoice, NoiseThatIsTheSameForAllValuesAsksForDifferences) {
  const MetricChoice choice = chosen(dark_gloss(0, 0.05, false, 100));
  EXPECT_EQ(choice.metric, Metric::cosine_l2);
  EXPECT_LT(factor_of(choice, Metric::cosine_l2), 2.2);
  EXPECT_GT(factor_of(choice, Metric::log_relative), factor_of(choice, Metric::cosine_l2));
}

TEST(MetricChoice, IsTheLogarithmWhereNothingIsKnownAndSaysWhy) {
  const MetricChoice exact = chosen(dark_gloss(0, 0));
  EXPECT_EQ(exact.metric, Metric::log);
  EXPECT_TRUE(exact.unevenness.empty());
  EXPECT_FALSE(exact.reason.empty());
  const MetricChoice weighted = chosen(dark_gloss(0.03, 0, true));
  EXPECT_EQ(weighted.metric, Metric::log);
  EXPECT_NE(weighted.reason.find("standard deviations"), std::string::npos);
}

TEST(MetricChoice, WhatIsAskedForIsUsed) {
  const MetricChoice choice = chosen(dark_gloss(0.03, 0), Metric::cube_root);
  EXPECT_EQ(choice.metric, Metric::cube_root);
  EXPECT_TRUE(choice.asked);
}

TEST(MetricChoice, IsInTheResultAndInItsJson) {
  const io::SampleTable table = dark_gloss(0.03, 0);
  FitOptions options;
  options.metric = Metric::automatic;
  options.cross_validation = false;
  const FitResult automatic = fit(table, {forms({"cook_torrance"})}, options);
  options.metric = automatic.metric.metric;
  const FitResult asked = fit(table, {forms({"cook_torrance"})}, options);
  EXPECT_EQ(automatic.ranking[0].material.terms[0].shape, asked.ranking[0].material.terms[0].shape);
  const io::Json json = to_json(automatic, table, options);
  EXPECT_EQ(json.at("metric"), name_of(automatic.metric.metric));
  EXPECT_EQ(json.at("metric_choice").at("noise_unevenness").size(), 3u);
  EXPECT_TRUE(to_json(asked, table, options).at("metric_choice").is_null());
  EXPECT_NEAR(json.at("samples").at("noise_floors").at("f").get<double>(), 0.03, 0.006);
}

}  // namespace
}  // namespace brdf::fit
