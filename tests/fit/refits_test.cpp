// Tests the refits of folds and bootstrap replicates: that parts add up to the whole, and how the
// replicates spread.
#include <gtest/gtest.h>

#include "fit/assess/refits.h"
#include "fit/report/report.h"
#include "io/files/error.h"
#include "samples.h"

namespace brdf::fit {
namespace {

Material satin() {
  Material m = make_material(*find_form("ward"), {"f"});
  m.terms[0].shape[0] = {0.2, 0.2};
  m.terms[0].weights[0] = {0.3, 0.1};
  return m;
}

FitOptions with_bootstrap(int replicates) {
  FitOptions options;
  options.bootstrap = replicates;
  options.seed = 7;
  return options;
}

TEST(Refits, InPartsAreThoseOfTheFitAtOnce) {
  const io::SampleTable table = measured(satin(), {"hemisphere"}, 0.03, 2, 15);
  const std::vector<std::vector<Reflectance>> models{forms({"ward"}), forms({"lambert"})};
  for (const bool folds : {true, false}) {
    FitOptions options = with_bootstrap(7);
    options.cross_validation = folds;
    const std::size_t count = count_refits(table, models.size(), options);
    ASSERT_EQ(count, 2u * (7u + (folds ? 5u : 0u)));  // 5 incidences
    RefitSolutions all;
    for (std::size_t first = 0; first < count; first += 5)  // parts that end within a model
      for (auto& solution :
           solve_refits(table, models, options, first, std::min<std::size_t>(5, count - first)))
        all.push_back(std::move(solution));
    ASSERT_EQ(all.size(), count);
    const FitResult at_once = fit(table, models, options), together = fit(table, models, options, {}, &all);
    EXPECT_EQ(io::to_text(to_json(at_once, table, options)), io::to_text(to_json(together, table, options)));
    EXPECT_EQ(at_once.ranking[0].left_out.has_value(), folds);
    all.back()[0] += 0.1;
    EXPECT_NE(io::to_text(to_json(at_once, table, options)),
              io::to_text(to_json(fit(table, models, options, {}, &all), table, options)));
    all.pop_back();
    EXPECT_THROW(fit(table, models, options, {}, &all), InputError);
  }
}

// For groups with independent noise, the spread of the replicates agrees with the standard error. The
// bounds allow a factor of 2.5.
TEST(Bootstrap, OfIndependentValuesSpreadsAsTheStandardErrorSays) {
  const io::SampleTable table = fine_hemisphere(satin(), 0.03, 3);
  FitOptions options = with_bootstrap(200);
  options.cross_validation = false;
  const FormFit found = fit_one(table, {"ward"}, options);
  EXPECT_EQ(found.replicates, 200u);
  for (const Estimate& e : found.estimates) {
    if (e.status != Status::free) continue;
    EXPECT_LT(e.bootstrap.low, e.value) << e.name;
    EXPECT_GT(e.bootstrap.high, e.value) << e.name;
    EXPECT_GT(e.bootstrap_error, 0.4 * e.standard_error) << e.name;
    EXPECT_LT(e.bootstrap_error, 2.5 * e.standard_error) << e.name;
  }
}

TEST(Bootstrap, FollowsFromTheSeed) {
  const io::SampleTable table = measured(satin(), {"hemisphere"}, 0.03, 2, 15);
  FitOptions options = with_bootstrap(20), other = options;
  other.seed = 8;
  const double error = estimate(fit_one(table, {"ward"}, options), "kd").bootstrap_error;
  EXPECT_GT(error, 0);
  EXPECT_EQ(error, estimate(fit_one(table, {"ward"}, options), "kd").bootstrap_error);
  EXPECT_NE(error, estimate(fit_one(table, {"ward"}, other), "kd").bootstrap_error);
  EXPECT_TRUE(std::isnan(estimate(fit_one(table, {"ward"}), "kd").bootstrap_error));
}

TEST(Bootstrap, NeedsAForm) {
  EXPECT_THROW(fit(measured(satin()), {}, with_bootstrap(3)), InputError);
}

}  // namespace
}  // namespace brdf::fit
