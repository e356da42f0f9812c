// Tests how systematic deviations are found: missing highlights, and lack of fit with its place and factor.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <sstream>

#include "brdf/geometry.h"
#include "fit/assess/lack_of_fit.h"
#include "fit/model/model.h"
#include "fit/report/html.h"
#include "fit/report/report.h"
#include "fit/report/states.h"
#include "fit/samples.h"
#include "fit/solve/minima.h"
#include "io/samples/noise.h"
#include "samples.h"

namespace brdf::fit {
namespace {

Material cook_torrance(double kd, double ks, double f0, double alpha) {
  Material m = make_material(*find_form("cook_torrance"), {"f"});
  m.terms[0].shape[0] = {alpha, alpha};
  m.terms[0].weights[0] = {kd, ks, f0};
  return m;
}

io::SampleTable hemisphere(const Material& m, double noise) {
  synth::Instrument instrument;
  instrument.noise = noise;
  return synth::measure(m, instrument);
}

FitOptions with(Metric metric) {
  FitOptions options;
  options.metric = metric;
  return options;
}

TEST(Highlight, GlossIsNoMattForm) {
  for (const double alpha : {0.03, 0.1, 0.5, 1.0}) {
    const io::SampleTable table = hemisphere(cook_torrance(0.8, 1, 0.04, alpha), 0.03);
    // At alpha 0.5 seven rows exceed twice the diffuse light. At alpha 1 the lobe adds less than half of
    // the diffuse light to any row.
    const bool gloss = alpha < 1;
    for (const Metric metric : {Metric::log, Metric::cosine_l2, Metric::cube_root, Metric::log_relative})
      for (const char* form : {"lambert", "oren_nayar"}) {
        const FormFit f = fit_one(table, {form}, with(metric));
        EXPECT_EQ(f.verdict == Verdict::misfit, gloss) << form << ' ' << alpha << ' ' << name_of(metric);
        EXPECT_TRUE(f.lack_of_fit.beyond_scatter) << form << ' ' << alpha << ' ' << name_of(metric);
      }
    EXPECT_EQ(fit(table, canonical_models(), {}).ranking[0].form, "cook_torrance");
  }
}

// Half of the scan lies in a broad lobe. A robust fit takes the level of the lobe for the level of the
// surface; the highlight must be found nevertheless.
TEST(Highlight, WhatAMattFormTakesForTheSurfaceIsOneToo) {
  Material m = make_material(*find_form("phong"), {"f"});
  m.terms[0].shape[0] = {2.74};
  m.terms[0].weights[0] = {0.217, 0.585};
  io::SampleTable table;
  for (int i = 1; i <= 80; ++i)
    for (int o : {15, 20, 30, 40, 45, 50, 60, 70, 80}) table.add_directions(o, 180, i, 0);
  table.channels = {"f"};
  table.values.resize(1);
  table.sigma.resize(1);
  const DirectionArrays<double> arrays = io::unit_directions(table);
  std::vector<double> f(1);
  for (std::size_t k = 0; k < table.theta_i.size(); ++k) {
    eval(m, arrays.view().wi(k), arrays.view().wo(k), f);
    table.values[0].push_back(f[0]);
  }
  const FormFit fitted = fit_one(table, {"lambert"}, with(Metric::cube_root));
  EXPECT_EQ(fitted.verdict, Verdict::misfit);
  EXPECT_NE(fitted.findings[0].find("this form cannot become as dark as the measurements"), std::string::npos)
      << fitted.findings[0];
}

TEST(Highlight, RowsThatStandOutAtRandomAreNone) {
  io::SampleTable table = hemisphere(make_material(*find_form("lambert"), {"f"}), 0.03);
  std::mt19937_64 random(3);
  for (int k = 0; k < 25; ++k) table.values[0][random() % table.rows()] *= 3;
  EXPECT_EQ(fit_one(table, {"lambert"}).verdict, Verdict::converged);
}

TEST(Highlight, AFormWithALobeIsNotJudgedByIt) {
  const io::SampleTable table = hemisphere(cook_torrance(0.3, 1, 0.04, 0.15), 0.03);
  for (const char* form : {"lambert", "oren_nayar"})
    EXPECT_EQ(fit_one(table, {form}).verdict, Verdict::misfit) << form;
  for (const char* form : {"phong", "blinn_phong", "ward", "cook_torrance"})
    EXPECT_NE(fit_one(table, {form}).verdict, Verdict::misfit) << form;
}

TEST(LackOfFit, OfTheRightFormIsNoneBeyondTheScatter) {
  for (const double alpha : {0.1, 0.3}) {
    const io::SampleTable table = hemisphere(cook_torrance(0.3, 0.6, 0.5, alpha), 0.03);
    const FormFit f = fit_one(table, {"cook_torrance"});
    EXPECT_FALSE(f.lack_of_fit.beyond_scatter);
    EXPECT_GT(*f.lack_of_fit.residual_over_scatter, 0.6);
    EXPECT_LT(*f.lack_of_fit.residual_over_scatter, 1.3);
  }
}

// Differences between mirrored rows of an anisotropic sample are no noise that excuses residuals.
TEST(LackOfFit, OfAnIsotropicFormIsNotExcusedByAnisotropy) {
  Material m = make_material(*find_form("ward"), {"f"});
  m.terms[0].weights[0] = {0.05, 0.2};
  m.terms[0].shape[0] = {0.25, 0.7};
  m.terms[0].tangent_phi = degrees(40);
  Samples samples;
  samples.table = measured(m, {"hemisphere"}, 0.01, 3, 5);
  samples.sheet = sheet::data_sheet(samples.table);
  const FormFit f = fit(samples, {forms({"ward"})}, {}).ranking.front();
  EXPECT_GT(f.median_relative_error, 0.1);
  EXPECT_FALSE(std::ranges::count(conditions_of(f), Condition::describes)) << verdict_sentence(f);
  EXPECT_NEAR(f.about.least_scatter.value_or(0), 0.01, 0.004);
}

// Rows 18 degrees apart show the shape of a narrow lobe as scatter; the residuals of the right form show that
// it is no noise, so nothing is consistent with it.
TEST(LackOfFit, ResidualsRefuteANoiseThatIsTheShapeOfALobe) {
  Material m = make_material(*find_form("ward"), {"f"});
  m.terms[0].weights[0] = {0.5, 0.3};
  m.terms[0].shape[0] = {0.1, 0.1};
  synth::Instrument instrument;
  instrument.grid.parts = {"in_plane"};
  instrument.grid.theta_i = {10, 30, 50, 70};
  instrument.grid.step = 18;
  instrument.noise = 0.01;
  const io::SampleTable table = synth::measure(m, instrument);
  const std::optional<double> alleged = io::relative_noise(table).value;
  ASSERT_GT(alleged.value_or(0), 0.1);
  const FitResult result = fit(table, {forms({"ward"}), forms({"lambert"})}, {});
  EXPECT_EQ(result.noise_floor, std::nullopt);
  EXPECT_THAT(result.refuted_noise, testing::HasSubstr("the residuals of ward"));
  EXPECT_EQ(result.ranking.front().form, "ward");
  EXPECT_FALSE(result.ranking.front().lack_of_fit.judged());
}

// Multiplies the values by `factor` if theta_h and theta_d lie between these angles, in degrees.
void scale_cell(io::SampleTable& table, std::pair<double, double> theta_h, std::pair<double, double> theta_d,
                double factor) {
  const auto within = [](Angle angle, const std::pair<double, double>& range) {
    return angle.degrees() > range.first && angle.degrees() < range.second;
  };
  const DirectionArrays<double> arrays = io::unit_directions(table);
  for (std::size_t k = 0; k < table.rows(); ++k) {
    const Geometry<double> g = geometry(arrays.view().wi(k), arrays.view().wo(k));
    if (within(radians(std::atan2(std::hypot(g.h.x, g.h.y), g.h.z)), theta_h) &&
        within(radians(std::acos(std::min(g.cos_d, 1.0))), theta_d))
      table.values[0][k] *= factor;
  }
}

// The surface is lambertian, except that it is three times as bright if theta_h is from 5 to 10 and theta_d
// from 30 to 45 degrees.
TEST(LackOfFit, IsSaidWithItsPlaceAndFactor) {
  io::SampleTable table = hemisphere(make_material(*find_form("lambert"), {"f"}), 0.02);
  const FitResult before = fit(table, {forms({"lambert"})}, {});
  EXPECT_FALSE(before.ranking[0].lack_of_fit.beyond_scatter);
  scale_cell(table, {5, 10}, {30, 45}, 3);
  const FitResult result = fit(table, {forms({"lambert"})}, {});
  const LackOfFit& lack = result.ranking[0].lack_of_fit;
  EXPECT_TRUE(lack.beyond_scatter);
  ASSERT_TRUE(lack.worst);
  EXPECT_EQ(lack.worst->range.low.theta_h, 5);
  EXPECT_EQ(lack.worst->range.high.theta_h, 10);
  EXPECT_EQ(lack.worst->range.low.theta_d, 30);
  EXPECT_EQ(lack.worst->range.high.theta_d, 45);
  EXPECT_NEAR(lack.worst->ratio, 3, 0.1);
  EXPECT_GT(lack.worst->share, 0.5);
  std::ostringstream text;
  print(text, result, table, {});
  EXPECT_NE(text.str().find("worst at theta_h 5 to 10, theta_d 30 to 45 degrees"), std::string::npos)
      << text.str();
  EXPECT_NE(html_report(result, table, {}).find("Lack of fit: residual"), std::string::npos);
}

// As above, and in addition two thirds as bright in a second cell further from the normal.
TEST(LackOfFit, NamesWhatElseIsOffAndItsSign) {
  io::SampleTable table = hemisphere(make_material(*find_form("lambert"), {"f"}), 0.02);
  EXPECT_TRUE(fit_one(table, {"lambert"}).lack_of_fit.others.empty());
  scale_cell(table, {5, 10}, {30, 45}, 3);
  scale_cell(table, {30, 45}, {15, 30}, 1 / 1.5);
  const LackOfFit lack = fit_one(table, {"lambert"}).lack_of_fit;
  ASSERT_TRUE(lack.worst);
  EXPECT_GT(lack.worst->ratio, 1);
  ASSERT_FALSE(lack.others.empty());
  EXPECT_LE(lack.others.size(), LackOfFit::kMostOthers);
  EXPECT_EQ(lack.others[0].range.low.theta_h, 30);
  EXPECT_EQ(lack.others[0].range.low.theta_d, 15);
  EXPECT_NEAR(lack.others[0].ratio, 1 / 1.5, 0.06);
  EXPECT_LT(lack.others[0].share, lack.worst->share);
  EXPECT_THAT(others_in_words(lack),
              testing::HasSubstr("other large residuals: at theta_h 30 to 45, theta_d 15 to 30 degrees ("));
}

TEST(LackOfFit, OtherMetricsAreTheThreeOthers) {
  const io::SampleTable table = hemisphere(cook_torrance(0.2, 0.3, 0.5, 0.1), 0.03);
  for (const Metric metric : kResiduals) {
    FitOptions options = with(metric);
    options.aperture = 0;
    const FitData data = prepare(table, options);
    const Model model(forms({"ward"}), table.channels, options);
    const SampleStream stream(data, model, chosen_residual(data, options), options.resolved_aperture());
    EXPECT_EQ(under_other_metrics(stream, model.initial(), options).size(), 3u);
  }
}

TEST(LackOfFit, IntervalsSayWhichIsWhich) {
  Material truth = cook_torrance(0.2, 0.3, 0.5, 0.1);
  truth.terms.push_back(truth.terms[0]);
  truth.terms[1].shape[0] = {0.35, 0.35};
  truth.terms[1].weights[0][0] = 0;
  const io::SampleTable table = hemisphere(truth, 0.03);
  const FitResult result = fit(table, {forms({"ward"})}, {});
  const FormFit& f = result.ranking[0];
  ASSERT_TRUE(f.lack_of_fit.beyond_scatter);
  int wider = 0;
  for (const Estimate& e : f.estimates) {
    ASSERT_EQ(e.status, Status::free) << e.name;
    EXPECT_LE(e.with_lack_of_fit.low, e.low);
    EXPECT_GE(e.with_lack_of_fit.high, e.high);
    EXPECT_LE(e.with_lack_of_fit.low, e.left_out.low);
    EXPECT_GE(e.with_lack_of_fit.high, e.left_out.high);
    EXPECT_LT(e.other_metrics.low, e.other_metrics.high);
    wider += e.with_lack_of_fit.high - e.with_lack_of_fit.low > 1.5 * (e.high - e.low);
  }
  EXPECT_GT(wider, 1);
  std::ostringstream text;
  print(text, result, table, {});
  EXPECT_NE(text.str().find("statistical, "), std::string::npos) << text.str();
  EXPECT_NE(text.str().find("with lack of fit; by other metrics "), std::string::npos) << text.str();
  const io::Json alpha = to_json(result, table, {})["ranking"][0]["intervals"]["alpha_x"];
  for (const char* key : {"with_lack_of_fit", "left_out", "other_metrics"})
    EXPECT_LT(alpha[key]["low"].get<double>(), alpha[key]["high"].get<double>()) << key;
}

}  // namespace
}  // namespace brdf::fit
