// Tests fits of many bands that share a shape.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fit/report/html.h"
#include "tests/fit/samples.h"
#include "tests/fit/spectra.h"

namespace brdf::fit {
namespace {

using testing::HasSubstr;
using testing::Not;

// The search for minima uses three of the bands. The result must be the minimum of all bands.
TEST(Spectrum, OfThirtyOneBandsTheTruthComesBack) {
  const Material truth = metal_of_31_bands();
  for (const Metric metric : {Metric::log, Metric::cosine_l2, Metric::log_relative}) {
    FitOptions options = without_cross_validation();
    options.metric = metric;
    const FormFit f = fit_one(measured(truth), {"cook_torrance"}, options);
    EXPECT_EQ(f.verdict, Verdict::converged);
    EXPECT_NEAR(f.material.terms[0].shape[0][0], 0.2, 1e-7);
    for (std::size_t band = 0; band < truth.channels.size(); ++band)
      EXPECT_LT(largest_relative_difference(f.material.terms[0].weights[band], truth.terms[0].weights[band]),
                1e-6)
          << truth.channels[band];
  }
}

TEST(Spectrum, AValueForEachBandIsStillHeld) {
  const Material truth = metal_of_31_bands();
  FitOptions options = without_cross_validation();
  options.fix.push_back({"f0", {}});
  for (const std::vector<double>& w : truth.terms[0].weights) options.fix.back().values.push_back(w[2]);
  const FormFit f = fit_one(measured(truth), {"cook_torrance"}, options);
  for (std::size_t band = 0; band < truth.channels.size(); ++band)
    EXPECT_EQ(f.material.terms[0].weights[band][2], truth.terms[0].weights[band][2]);
  EXPECT_NEAR(f.material.terms[0].shape[0][0], 0.2, 1e-7);
}

TEST(Spectrum, AReportDrawsItOverWavelength) {
  const io::SampleTable table = measured(metal_of_bands(50), {"hemisphere"}, 0.02);
  const FitOptions options = without_cross_validation();
  const FitResult result = fit(table, {forms({"cook_torrance"})}, options);
  const std::string page = html_report(result, table, options);
  for (const char* parameter : {"kd", "ks", "f0"})
    EXPECT_THAT(page, HasSubstr(std::string(parameter) + " over wavelength"));
  EXPECT_THAT(page, HasSubstr("in the studio"));
  const io::SampleTable rgb = measured(make_material(*find_form("ward")), {"hemisphere"}, 0.02);
  EXPECT_THAT(html_report(fit(rgb, {forms({"ward"})}, options), rgb, options),
              Not(HasSubstr("over wavelength")));
}

// Models are fitted in parallel. The result must not depend on the number of threads.
TEST(FitThreads, AnyNumberGivesTheSameResult) {
  const io::SampleTable table = measured(make_material(*find_form("ward")), {"hemisphere"}, 0.03);
  FitOptions one, three;
  one.metric = three.metric = Metric::log_relative;
  three.threads = 3;
  const FitResult a = fit(table, canonical_models(), one), b = fit(table, canonical_models(), three);
  ASSERT_EQ(a.ranking.size(), b.ranking.size());
  for (std::size_t k = 0; k < a.ranking.size(); ++k) {
    EXPECT_EQ(a.ranking[k].form, b.ranking[k].form);
    EXPECT_EQ(a.ranking[k].material, b.ranking[k].material);
    ASSERT_TRUE(a.ranking[k].left_out && b.ranking[k].left_out);
    EXPECT_EQ(a.ranking[k].left_out->value, b.ranking[k].left_out->value);
  }
}

}  // namespace
}  // namespace brdf::fit
