// Tests that fits recover the truth of synthetic samples, for every form, metric and kind of model.
#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "samples.h"

namespace brdf::fit {
namespace {

double worst_parameter(const Material& fitted, const Material& truth) {
  double worst = 0;
  for (std::size_t t = 0; t < truth.terms.size(); ++t) {
    worst = std::max(worst, largest_relative_difference(fitted.terms[t].shape[0], truth.terms[t].shape[0]));
    for (std::size_t c = 0; c < truth.channels.size(); ++c)
      worst =
          std::max(worst, largest_relative_difference(fitted.terms[t].weights[c], truth.terms[t].weights[c]));
  }
  return worst;
}

TEST(Recovery, NoiseFreeDefaultsOfEveryForm) {
  for (const Reflectance& form : catalogue()) {
    if (!info(form).fittable()) continue;
    Material truth = make_material(form);
    for (std::vector<double>& weights : truth.terms[0].weights)
      for (double& w : weights)
        if (w == 0) w = 0.02;  // of a basis: an error relative to 0 has no meaning
    const FormFit f = fit(measured(truth), {{form}}, without_cross_validation()).ranking.front();
    EXPECT_LT(worst_parameter(f.material, truth), 1e-8) << f.form;
    // Some forms at their defaults reflect more than they receive.
    const bool breaks = f.largest_measured_albedo->breaks_energy();
    EXPECT_EQ(f.verdict == Verdict::breaks_energy, breaks) << f.form;
    EXPECT_EQ(usable(f.verdict), !breaks) << f.form << ": " << name_of(f.verdict);
  }
}

TEST(Recovery, EveryMetricFindsTheSameNoiseFreeTruth) {
  Material truth = make_material(*find_form("cook_torrance"));
  truth.terms[0].shape[0] = {0.12, 0.12};
  truth.terms[0].weights = {{0.3, 0.6, 0.1}, {0.2, 0.6, 0.2}, {0.1, 0.6, 0.5}};
  const io::SampleTable table = measured(truth);
  for (Metric metric : {Metric::log, Metric::cosine_l2, Metric::cube_root, Metric::log_relative}) {
    FitOptions options = without_cross_validation();
    options.metric = metric;
    EXPECT_LT(worst_parameter(fit_one(table, {"cook_torrance"}, options).material, truth), 1e-7)
        << int(metric);
  }
}

TEST(Recovery, AnisotropicWidthsAndTheirDirection) {
  Material truth = make_material(*find_form("ward"), {"f"});
  truth.terms[0].shape[0] = {0.05, 0.16};
  truth.terms[0].tangent_phi = radians(0.4);
  synth::Instrument instrument;
  instrument.grid.azimuths = {0, 30, 60, 90, 120, 150};
  instrument.grid.theta_i = {20, 50};
  instrument.grid.step = 10;
  FitOptions options = without_cross_validation();
  options.anisotropic = true;
  const FormFit f = fit_one(synth::measure(truth, instrument), {"ward"}, options);
  EXPECT_EQ(f.verdict, Verdict::converged);
  EXPECT_LT(worst_parameter(f.material, truth), 1e-7);
  EXPECT_NEAR(f.material.terms[0].tangent_phi.radians(), 0.4, 1e-7);
}

TEST(Recovery, DiffuseTermPlusLobeAndTwoLobes) {
  Material truth = make_material(*find_form("oren_nayar"));
  truth.terms.push_back(make_term(*find_form("ward"), 3));
  truth.terms[0].shape[0] = {0.5};
  truth.terms[1].shape[0] = {0.1, 0.1};
  for (auto& w : truth.terms[1].weights) w[0] = 0;  // the first term has the diffuse part
  FormFit f = fit_one(measured(truth), {"oren_nayar", "ward"}, without_cross_validation());
  EXPECT_EQ(f.verdict, Verdict::converged);
  EXPECT_LT(std::abs(f.material.terms[0].shape[0][0] - 0.5), 1e-7);
  EXPECT_LT(std::abs(f.material.terms[1].shape[0][0] - 0.1), 1e-8);
  EXPECT_EQ(f.material.terms[1].weights[0][0], 0);

  truth = make_material(*find_form("ward"), {"f"});
  truth.terms.push_back(make_term(*find_form("ward"), 1));
  truth.terms[0].shape[0] = {0.06, 0.06};
  truth.terms[1].shape[0] = {0.35, 0.35};
  truth.terms[0].weights[0] = {0.2, 0.1};
  truth.terms[1].weights[0] = {0, 0.3};
  f = fit_one(measured(truth), {"ward", "ward"}, without_cross_validation());
  EXPECT_LT(std::abs(f.material.terms[0].shape[0][0] - 0.06), 1e-8);
  EXPECT_LT(std::abs(f.material.terms[1].shape[0][0] - 0.35), 1e-7);
  EXPECT_NEAR(f.material.terms[1].weights[0][1], 0.3, 1e-7);
}

TEST(Recovery, AShapePerChannel) {
  Material truth = make_material(*find_form("blinn_phong"));
  truth.terms[0].shape = {{10}, {40}, {160}};
  FitOptions options = without_cross_validation();
  options.per_channel = true;
  const FormFit f = fit_one(measured(truth), {"blinn_phong"}, options);
  ASSERT_EQ(f.material.terms[0].shape.size(), 3u);
  for (std::size_t c = 0; c < 3; ++c)
    EXPECT_NEAR(f.material.terms[0].shape[c][0] / truth.terms[0].shape[c][0], 1, 1e-8);
}

TEST(Recovery, FixedAndBoundedParametersAreObeyed) {
  Material truth = make_material(*find_form("cook_torrance"), {"f"});
  truth.terms[0].shape[0] = {0.2, 0.2};
  truth.terms[0].weights[0] = {0.3, 0.5, 0.2};
  const io::SampleTable table = measured(truth);
  FitOptions options = without_cross_validation();
  options.fix = {{"f0", {0.2}}};
  FormFit f = fit_one(table, {"cook_torrance"}, options);
  EXPECT_LT(worst_parameter(f.material, truth), 1e-8);
  options.fix = {{"alpha", {0.25}}, {"kd", {0.3}}};
  f = fit_one(table, {"cook_torrance"}, options);
  EXPECT_EQ(f.material.terms[0].shape[0][0], 0.25);
  EXPECT_EQ(f.material.terms[0].shape[0][1], 0.25);
  EXPECT_EQ(f.material.terms[0].weights[0][0], 0.3);
  options.fix.clear();
  options.bounds = {{"alpha", 0.3, 0.5}, {"f0", 0.1, 0.15}};
  f = fit_one(table, {"cook_torrance"}, options);
  EXPECT_EQ(f.verdict, Verdict::at_bound);
  EXPECT_NEAR(f.material.terms[0].shape[0][0], 0.3, 1e-12);
  EXPECT_GE(f.material.terms[0].weights[0][2], 0.1 - 1e-12);
  EXPECT_LE(f.material.terms[0].weights[0][2], 0.15 + 1e-12);
}

}  // namespace
}  // namespace brdf::fit
