// Tests the verdict of a fit on good samples, on misfits, and on tables that determine too little.
#include <gtest/gtest.h>

#include <sstream>

#include "fit/assess/select.h"
#include "fit/report/html.h"
#include "fit/report/report.h"
#include "io/files/error.h"
#include "samples.h"

namespace brdf::fit {
namespace {

io::SampleTable constant_table(double value) {
  io::SampleTable table = measured(make_material(*find_form("lambert"), {"f"}));
  for (double& v : table.values[0]) v = value;
  return table;
}

TEST(Verdict, ConstantDataIsLambertAndLeavesWardUnidentified) {
  const FitResult result = fit(constant_table(0.2), canonical_models(), {});
  EXPECT_EQ(result.ranking.front().form, "lambert");
  EXPECT_EQ(result.ranking.front().verdict, Verdict::converged);
  for (const FormFit& f : result.ranking) {
    if (f.form != "ward") continue;
    EXPECT_EQ(f.verdict, Verdict::not_identifiable);
    EXPECT_FALSE(usable(f.verdict));
  }
}

TEST(Verdict, NoisyConstantDataIsStillLambert) {
  Material white = make_material(*find_form("lambert"));
  const FitResult result = fit(measured(white, {"hemisphere"}, 0.05), canonical_models(), {});
  EXPECT_EQ(result.ranking[result.recommended].form, "lambert");
}

// Adds a retroreflective lobe of the same shape to `table`, `share` times as strong. No form has both
// lobes.
void add_retro_lobe(io::SampleTable& table, const Material& lobe, double share) {
  io::SampleTable mirrored = table;  // viewed from the light's side, the mirror lobe is a retroreflection
  for (double& phi : mirrored.phi_o) phi += 180;
  const DirectionArrays<double> arrays = io::unit_directions(mirrored);
  const Directions<double> d = arrays.view();
  std::vector<double> value(1);
  for (std::size_t k = 0; k < table.rows(); ++k) {
    eval(lobe, d.wi(k), d.wo(k), value);
    table.values[0][k] += share * value[0];
  }
}

// With alpha 0.05 and 0.1 on a bright base, the lobes are a few rows among a thousand that fit well.
TEST(Verdict, RetroReflectorIsAMisfit) {
  struct Case {
    double alpha, kd;
  };
  for (const Case& c : {Case{0.15, 0.05}, {0.1, 0.5}, {0.05, 0.9}, {0.4, 0.02}}) {
    Material material = make_material(*find_form("cook_torrance"), {"f"});
    material.terms[0].shape[0] = {c.alpha, c.alpha};
    material.terms[0].weights[0] = {c.kd, 0.5, 0.5};
    io::SampleTable table = measured(material, {"hemisphere"}, 0, 1, 5);
    add_retro_lobe(table, material, 1);
    for (const FormFit& f : fit(table, canonical_models(), {}).ranking)
      EXPECT_EQ(f.verdict, Verdict::misfit) << f.form << " alpha " << c.alpha;
  }
}

// A retroreflection of a tenth of the mirror lobe on a dull surface is within the usual deviations of
// measurements.
TEST(Verdict, AFaintHighlightBackToTheLightIsNotAMisfit) {
  Material material = make_material(*find_form("cook_torrance"), {"f"});
  material.terms[0].shape[0] = {0.3, 0.3};
  material.terms[0].weights[0] = {0.5, 0.2, 0.5};
  io::SampleTable table = measured(material, {"hemisphere"}, 0, 1, 5);
  add_retro_lobe(table, material, 0.1);
  EXPECT_TRUE(usable(fit_one(table, {"cook_torrance"}).verdict));
}

TEST(Verdict, AMeasurementWithoutLightIsRefused) {
  for (const Metric metric : {Metric::log, Metric::cosine_l2, Metric::log_relative, Metric::cube_root})
    for (const double value : {0.0, -1e-5, -0.5}) {
      FitOptions options;
      options.metric = metric;
      try {
        fit(constant_table(value), canonical_models(), options);
        ADD_FAILURE() << name_of(metric) << " fits " << value;
      } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find("all values to fit are 0 or below"), std::string::npos)
            << error.what();
      }
    }
}

TEST(Verdict, AChannelWithoutLightHasNoWeightBesideOthers) {
  Material truth = make_material(*find_form("lambert"), {"r", "g", "b"});
  truth.terms[0].weights[2] = {0};
  const FormFit f = fit_one(measured(truth), {"lambert"});
  EXPECT_EQ(f.material.terms[0].weights[2][0], 0);
  EXPECT_EQ(f.verdict, Verdict::at_bound);
}

TEST(Verdict, FiveRowsAreTooFewForThreeParameters) {
  io::SampleTable table = measured(make_material(*find_form("ward"), {"f"}));
  for (auto* column : {&table.theta_i, &table.phi_i, &table.theta_o, &table.phi_o, &table.values[0]})
    column->resize(5);
  table.lines.clear();
  const FormFit f = fit_one(table, {"cook_torrance"});
  EXPECT_FALSE(usable(f.verdict)) << name_of(f.verdict);
}

TEST(Verdict, OrderAndDuplicatesOfRowsDoNotMatter) {
  const io::SampleTable table = measured(make_material(*find_form("ward"), {"f"}), {"hemisphere"}, 0.03);
  io::SampleTable shuffled = table;
  const std::size_t n = table.rows();
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t from = (k * 7919 + 13) % n;
    shuffled.theta_i[k] = table.theta_i[from], shuffled.phi_i[k] = table.phi_i[from];
    shuffled.theta_o[k] = table.theta_o[from], shuffled.phi_o[k] = table.phi_o[from];
    shuffled.values[0][k] = table.values[0][from];
  }
  io::SampleTable doubled = table;
  for (std::size_t k = 0; k < n; ++k) {
    doubled.theta_i.push_back(table.theta_i[k]), doubled.phi_i.push_back(table.phi_i[k]);
    doubled.theta_o.push_back(table.theta_o[k]), doubled.phi_o.push_back(table.phi_o[k]);
    doubled.values[0].push_back(table.values[0][k]);
  }
  const double alpha = fit_one(table, {"ward"}).material.terms[0].shape[0][0];
  EXPECT_NEAR(fit_one(shuffled, {"ward"}).material.terms[0].shape[0][0], alpha, 1e-7);
  EXPECT_NEAR(fit_one(doubled, {"ward"}).material.terms[0].shape[0][0], alpha, 1e-7);
}

TEST(Verdict, ManyChannelsShareAShape) {
  Material truth = make_material(*find_form("ward"), std::vector<std::string>(31, ""));
  for (std::size_t c = 0; c < 31; ++c) {
    truth.channels[c] = "nm" + std::to_string(400 + 10 * c);
    truth.terms[0].weights[c] = {0.1 + 0.01 * double(c), 0.3 + 0.01 * double(c)};
  }
  const FormFit f = fit_one(measured(truth), {"ward"});
  EXPECT_EQ(f.verdict, Verdict::converged);
  for (std::size_t c = 0; c < 31; ++c)
    EXPECT_LT(largest_relative_difference(f.material.terms[0].weights[c], truth.terms[0].weights[c]), 1e-8);
}

TEST(Verdict, UnknownParametersAndImpossibleCutsAreRefused) {
  const io::SampleTable table = constant_table(0.1);
  FitOptions options;
  options.fix = {{"alpha", {0.1}}};
  EXPECT_THROW(fit_one(table, {"lambert"}, options), InputError);
  options = {};
  options.max_theta = 5;
  EXPECT_THROW(fit_one(table, {"lambert"}, options), InputError);
  options = {};
  options.fix = {{"rho", {-1}}};
  EXPECT_THROW(fit_one(table, {"lambert"}, options), InputError);
}

TEST(Verdict, WithoutAFiniteCostNoErrorIsKnownAndNothingIsSaidOnTheTerminal) {
  FitOptions options;
  options.metric = Metric::cosine_l2;
  const io::SampleTable table = constant_table(1e180);
  testing::internal::CaptureStderr();
  const FitResult result = fit(table, {forms({"lambert"}), forms({"ward"})}, options);
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_FALSE(result.ranking.front().solved());
  EXPECT_EQ(result.ranking.front().verdict, Verdict::diverged);
  std::ostringstream text;
  print(text, result, table, options);
  EXPECT_NE(text.str().find("diverged         -         -        -       -  "), std::string::npos)
      << text.str();
  const io::Json first = to_json(result, table, options)["ranking"][0];
  for (const char* key : {"material", "median_relative_error", "bic"})
    EXPECT_TRUE(first[key].is_null()) << key;
  EXPECT_GT(html_report(result, table, options).size(), 1000u);
}

TEST(Verdict, AFormWithoutASolutionRanksLast) {
  FitResult result = fit(constant_table(0.2), {forms({"ward"}), forms({"lambert"})}, {});
  FormFit unsolved;
  unsolved.form = "unsolved";
  result.ranking.insert(result.ranking.begin(), unsolved);
  rank(result);
  EXPECT_EQ(result.ranking.back().form, "unsolved");
  EXPECT_EQ(result.ranking[result.recommended].form, "lambert");
}

TEST(Verdict, TheShareOfTheLightDoesNotReverseTheRanking) {
  FitResult result = fit(constant_table(0.2), {forms({"lambert"})}, {});
  FormFit better = result.ranking.front(), worse = better;
  better.form = "better";
  better.verdict = Verdict::misfit;
  better.left_out->value = 1;
  worse.form = "worse";
  worse.left_out->value = 2;
  result.ranking = {worse, better};
  rank(result);
  EXPECT_EQ(result.ranking.back().verdict, worse.verdict)
      << "a missing highlight says nothing of other forms";
  better.light_is_off = true;
  result.ranking = {worse, better};
  for (int times = 0; times < 2; ++times) rank(result);
  EXPECT_EQ(result.ranking.front().form, "better");
  EXPECT_EQ(result.ranking.back().verdict, Verdict::misfit);
  EXPECT_EQ(result.ranking.back().findings.front(), "predicts worse than better, which is a misfit");
  EXPECT_EQ(result.ranking.back().findings.size(), worse.findings.size() + 1);
}

// For three values at one pair of directions, the interval of the mean has two degrees of freedom.
TEST(Verdict, IntervalsOfFewValuesAreStudents) {
  io::SampleTable table;
  table.channels = {"f"};
  table.values = {{0.1, 0.2, 0.3}};
  table.sigma.resize(1);
  for (int k = 0; k < 3; ++k) table.add_directions(20, 180, 40, 0);
  FitOptions options;
  options.metric = Metric::cosine_l2;
  options.cross_validation = false;
  const Estimate rho = fit_one(table, {"lambert"}, options).estimates.front();
  ASSERT_EQ(rho.status, Status::free);
  EXPECT_NEAR((rho.high - rho.value) / rho.standard_error, 4.302652729911275, 1e-9);
}

// Counts are constant: the surface is matt, and only the range of rho keeps the fit from them.
TEST(Verdict, AScaleBeyondTheWeightsIsNoPropertyOfTheSurface) {
  const FormFit f = fit_one(constant_table(20000), {"lambert"}, {});
  EXPECT_EQ(f.verdict, Verdict::misfit);
  EXPECT_TRUE(f.findings.front().starts_with("the measured values are about ")) << f.findings.front();
  EXPECT_NE(f.findings.front().find("times the fitted ones in all directions"), std::string::npos);
  EXPECT_EQ(fit_one(constant_table(0.2), {"lambert"}, {}).verdict, Verdict::converged);
}

// The rows of one form alone were held out before the interruption: all forms are then ranked by the fitted
// rows, and nothing follows from the missing value.
TEST(Verdict, AnInterruptionMakesNoFormAMisfit) {
  FitResult result;
  FormFit off, good;
  off.form = "lambert";
  off.verdict = Verdict::misfit;
  off.light_is_off = true;
  off.median_relative_error = 0.9;
  off.left_out.emplace();
  off.left_out->value = 0.02;
  good.form = "ward";
  good.verdict = Verdict::converged;
  good.median_relative_error = 1e-6;
  result.ranking = {off, good};
  rank(result);
  EXPECT_EQ(result.ranking.front().form, "ward");
  EXPECT_EQ(result.ranking.front().verdict, Verdict::converged);
}

TEST(Verdict, AnInterruptedFitReturnsItsBestAndSaysSo) {
  std::atomic<bool> stop = true;
  FitOptions options;
  options.interrupted = &stop;
  const FormFit f = fit_one(constant_table(0.2), {"ward"}, options);
  EXPECT_EQ(f.verdict, Verdict::interrupted);
  EXPECT_FALSE(usable(f.verdict));
}

}  // namespace
}  // namespace brdf::fit
