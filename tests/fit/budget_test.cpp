// Tests the uncertainty budget of an instrument: sensitivities, shared errors, and the coverage of intervals.
#include "fit/assess/budget.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <initializer_list>
#include <sstream>

#include "fit/assess/derived.h"
#include "fit/assess/propagation.h"
#include "fit/report/budget.h"
#include "fit/report/report.h"
#include "samples.h"
#include "simulated_instrument.h"

namespace brdf::fit {
namespace {

using testing::HasSubstr;
using testing::Not;

FormFit fitted(const io::SampleTable& table, const Instrument& instrument, const char* form,
               std::vector<NamedValues> fix = {}) {
  FitOptions options{.metric = Metric::log_relative};
  options.fix = std::move(fix);
  options.budget = budget_of(instrument);
  return fit(table, {{*find_form(form)}}, options).ranking.front();
}

double part(const Combined& c, const std::string& source) {
  const auto found = std::ranges::find(c.parts, source, &Combined::Part::source);
  return found == c.parts.end() ? 0 : found->standard_uncertainty;
}

RowMatrix diagonal(std::initializer_list<double> variances) {
  RowMatrix out = RowMatrix::Zero(Eigen::Index(variances.size()), Eigen::Index(variances.size()));
  Eigen::Index k = 0;
  for (const double v : variances) out(k, k) = v, ++k;
  return out;
}

// Turned, so that no direction is that of a parameter; the parameters differ by many orders.
RowMatrix turned(const RowMatrix& m) {
  RowMatrix turn(3, 3), scale = diagonal({1e-6, 1, 1e5});
  turn << 0.6, -0.8, 0, 0.64, 0.48, -0.6, 0.48, 0.36, 0.8;
  return scale * turn * m * turn.transpose() * scale;
}

void expect_near(const RowMatrix& a, const RowMatrix& b) {
  for (Eigen::Index i = 0; i < a.rows(); ++i)
    for (Eigen::Index j = 0; j < a.cols(); ++j)
      EXPECT_NEAR(a(i, j), b(i, j), 1e-9 * std::sqrt(b(i, i) * b(j, j))) << i << ' ' << j;
}

// Also in a direction in which one of the two, or both, have no variance.
TEST(Propagation, TheLargerOfTwoCovariancesIsTakenInEveryDirection) {
  const RowMatrix own = turned(diagonal({4, 0, 1})), other = turned(diagonal({1, 2, 3}));
  expect_near(larger_of(own, other, 1), turned(diagonal({4, 2, 3})));
  expect_near(larger_of(own, other, 0.5), turned(diagonal({4, 1, 2})));
  expect_near(larger_of(own, other, 1, 3.5), turned(diagonal({4, 2, 1})));  // 3 is not more than 3.5 times 1
  expect_near(larger_of(own, turned(diagonal({1, 0, 3})), 1), turned(diagonal({4, 0, 3})));
}

TEST(Propagation, ACovarianceShrinksInTheDirectionsThatShrinkAndGrowsInNone) {
  const RowMatrix before = turned(diagonal({4, 2, 1})), after = turned(diagonal({1, 2, 5}));
  expect_near(shrunk(before, before, after), turned(diagonal({1, 2, 1})));
  expect_near(shrunk(turned(diagonal({8, 3, 7})), before, after), turned(diagonal({2, 3, 7})));
}

// The value of a matt surface does not depend on the angles, so that only the division by the nominal cosine
// of the viewing angle is sensitive to them.
TEST(Budget, ASurfaceWithoutAnglesIsSensitiveToTheCosineAlone) {
  const Instrument instrument{.scale = 0.004, .zero_i = 0.3, .zero_o = 0.2, .noise = 0};
  const FormFit f = fitted(read_by({}, matt(0.6)), instrument, "lambert");
  const RowBudget& rows = f.budget.value();
  ASSERT_GT(rows.row.size(), 50u);
  for (std::size_t k = 0; k < rows.row.size(); ++k) {
    const double theta_o = degrees(read_by({}, matt(0.6)).theta_o[rows.row[k]]).radians();
    EXPECT_NEAR(rows.theta_i[0][k], 0, 1e-9);
    EXPECT_NEAR(rows.theta_o[0][k], -std::tan(theta_o), 1e-7);
    EXPECT_NEAR(rows.combined(0, k), std::hypot(0.004, degrees(0.2).radians() * std::tan(theta_o)), 1e-9);
  }
  EXPECT_EQ(rows.beyond_first_order, 0u);
}

// Twice as many rows halve the variance of the errors that each row has for itself, and leave an error that
// all rows share as large as it was.
TEST(Budget, ASharedErrorIsNotDividedByTheRootOfTheNumberOfRows) {
  const Instrument instrument{.scale = 0.01, .zero_i = 0, .zero_o = 0, .noise = 0.02};
  io::SampleTable once = read_by({}, matt(0.5)), twice = once;
  for (std::size_t k = 0; k < once.rows(); ++k) {
    twice.add_directions(once.theta_i[k], once.phi_i[k], once.theta_o[k], once.phi_o[k]);
    twice.values[0].push_back(once.values[0][k]);
  }
  const Combined a = estimate(fitted(once, instrument, "lambert"), "rho").budget.value(),
                 b = estimate(fitted(twice, instrument, "lambert"), "rho").budget.value();
  EXPECT_NEAR(part(a, "reference_standard"), 0.5 * 0.01, 1e-7);
  EXPECT_NEAR(part(b, "reference_standard"), 0.5 * 0.01, 1e-7);
  EXPECT_NEAR(part(b, "repeatability"), part(a, "repeatability") / std::sqrt(2), 1e-7);
  EXPECT_NEAR(part(a, "repeatability"), 0.5 * 0.02 / std::sqrt(double(once.rows())), 2e-5);
}

TEST(Budget, AnErrorOfEachLightIsDividedByTheirNumber) {
  Instrument instrument{.scale = 0.01, .zero_i = 0, .zero_o = 0, .noise = 0};
  const io::SampleTable table = read_by({}, matt(0.5));
  auto budget = *budget_of(instrument);
  budget.sources[0].shared_by = io::SharedBy::light;
  FitOptions options{.metric = Metric::log_relative};
  options.budget = std::make_shared<const io::Budget>(budget);
  const FormFit f = fit(table, {{*find_form("lambert")}}, options).ranking.front();
  const double lights = double(std::set(table.theta_i.begin(), table.theta_i.end()).size());
  EXPECT_NEAR(part(estimate(f, "rho").budget.value(), "reference_standard"), 0.5 * 0.01 / std::sqrt(lights),
              0.5 * 0.01 * 0.01);
}

// An encoder writes the angle of one light with jitter, its azimuth as -180 or 180, and any azimuth at the
// normal. These rows still share the error of the light.
TEST(Budget, ALightIsOneLightWithinTheJitterOfItsAngles) {
  Instrument instrument{.scale = 0.01, .zero_i = 0, .zero_o = 0, .noise = 0};
  const io::SampleTable table = read_by({}, matt(0.5));
  auto budget = *budget_of(instrument);
  budget.sources[0].shared_by = io::SharedBy::light;
  FitOptions options{.metric = Metric::log_relative};
  options.budget = std::make_shared<const io::Budget>(budget);
  io::SampleTable written = table;
  for (std::size_t k = 0; k < written.rows(); ++k) {
    written.theta_i[k] += 0.003 * std::sin(double(k));
    if (k % 2) written.phi_i[k] -= 360;
    if (table.theta_i[k] == 0) written.theta_i[k] = 0, written.phi_i[k] = double(k % 90);
  }
  const auto of_lights = [&](const io::SampleTable& t) {
    const FormFit f = fit(t, {{*find_form("lambert")}}, options).ranking.front();
    EXPECT_EQ(f.budget.value().lights, std::set(table.theta_i.begin(), table.theta_i.end()).size());
    return part(estimate(f, "rho").budget.value(), "reference_standard");
  };
  EXPECT_NEAR(of_lights(written), of_lights(table), 1e-6);
}

// The budget's own repeatability is far below the scatter of these rows, so that the scatter counts.
TEST(Budget, TheScatterOfTheRowsCountsIfItIsLarger) {
  const Instrument stated{.scale = 0.01, .zero_i = 0, .zero_o = 0, .noise = 1e-5};
  const FormFit f = fitted(read_by({.noise = 0.03}, matt(0.5), 3), stated, "lambert");
  const Combined kd = estimate(f, "rho").budget.value();
  EXPECT_EQ(part(kd, "repeatability"), 0);
  EXPECT_NEAR(part(kd, kScatterSource), 0.5 * 0.03 / std::sqrt(double(f.budget->row.size())), 4e-4);
}

// Simulated instruments, each with errors of its own: the 95 % intervals hold the true parameters and the
// true albedo. The standard deviation of a share of 1,000 is 0.7 %.
TEST(Budget, IntervalsOfAThousandInstrumentsHoldTheTruth) {
  for (const auto& [name, share] : covered_by_budget(1000, 1)) {
    RecordProperty(name, std::to_string(share));
    EXPECT_GE(share, 0.93) << name;
    EXPECT_LE(share, 0.97) << name;
  }
}

// Without a budget the same intervals miss the true weight of the diffuse term in most tables, and the report
// states that a common error is not in them.
TEST(Budget, WithoutABudgetTheReportStatesThatScatterAloneIsInIt) {
  const Instrument instrument;
  const FitOptions plain{.metric = Metric::log_relative, .fix = {{"f0", {0.05}}}};
  int held = 0;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const FormFit f =
        fit(read_by(instrument, glossy(), seed), {{*find_form("cook_torrance")}}, plain).ranking.front();
    const Estimate& kd = estimate(f, "kd");
    held += kd.low <= kGlossyKd && kGlossyKd <= kd.high;
    EXPECT_EQ(scope_of_intervals(f), std::string("intervals: ") + kScatterOnly);
    EXPECT_TRUE(budget_in_words(f).empty());
    EXPECT_TRUE(budget_json(f, nullptr).is_null());
  }
  EXPECT_LE(held, 8);
}

// Two rows give no interval, so that no sentence may state what is in it.
TEST(Budget, WithoutIntervalsNothingIsStatedOfThem) {
  io::SampleTable table;
  table.set_channels({"f"});
  table.add_directions(10, 180, 20, 0);
  table.add_directions(10, 180, 30, 0);
  table.values = {{0.1, 0.11}};
  FitOptions options{.metric = Metric::log_relative};
  options.budget = budget_of({});
  const FitResult result = fit(table, {{*find_form("oren_nayar")}}, options);
  std::ostringstream text;
  print(text, result, table, options);
  EXPECT_FALSE(has_intervals(result.ranking.front()));
  EXPECT_THAT(text.str(), Not(HasSubstr("intervals:")));
}

TEST(Budget, EveryIntervalStatesThatItContainsTheBudget) {
  FitOptions options{.metric = Metric::log_relative, .fix = {{"f0", {0.05}}}};
  options.budget = budget_of({});
  const io::SampleTable table = read_by({}, glossy(), 5);
  const FitResult result = fit(table, {{*find_form("cook_torrance")}}, options);
  std::ostringstream text;
  print(text, result, table, options);
  EXPECT_THAT(text.str(), HasSubstr("with the budget)"));
  EXPECT_THAT(text.str(), Not(HasSubstr("scatter only")));
  const io::Json json = to_json(result, table, options);
  EXPECT_EQ(json["ranking"][0]["intervals_contain"], "scatter and budget");
  EXPECT_EQ(json["ranking"][0]["budget"]["rows"].size(), result.rows);
  double shares = 0;
  for (const auto& source : json["ranking"][0]["intervals"]["kd"]["f"]["budget"]["sources"])
    shares += source["share"].get<double>();
  EXPECT_NEAR(shares, 1, 1e-9);
}

TEST(Budget, ItsSourcesComeBackFromAMaterialFile) {
  const FormFit f = fitted(read_by({}, glossy(), 2), {}, "cook_torrance", {{"f0", {0.05}}});
  const auto back = covariance_of({{"covariance", to_json(f.covariance.value())}});
  ASSERT_TRUE(back);
  EXPECT_EQ(back->sources, f.covariance->sources);
  EXPECT_EQ(back->components.a, f.covariance->components.a);
  EXPECT_GT(back->components.rows, back->components.cols);
  EXPECT_FALSE(covariance_of(
      {{"covariance", {{"parameters", {"a"}}, {"components", {{1}, {1}}}, {"freedom", {9, 9}}}}}));
}

// A slope of 0 is at its bound: its interval has the budget, but no standard uncertainty is stated, which
// would be that of the square.
TEST(Budget, AParameterAtItsBoundHasAnIntervalAlone) {
  const FormFit f = fitted(read_by({}, matt(0.5)), {}, "oren_nayar");
  const Estimate& sigma = estimate(f, "sigma");
  EXPECT_EQ(sigma.status, Status::at_bound);
  EXPECT_FALSE(sigma.budget);
  EXPECT_NEAR(sigma.high, 0.03, 0.01);
  EXPECT_THAT(testing::PrintToString(budget_in_words(f)), Not(HasSubstr("uncertainty of sigma")));
}

// A lobe as narrow as a few zero errors: first order is not enough, and the report states it.
TEST(Budget, ANarrowHighlightIsBeyondFirstOrder) {
  Material mirror = glossy();
  mirror.terms[0].shape[0] = {0.01, 0.01};
  const FormFit f =
      fitted(read_by({}, mirror), {.zero_i = 0.3, .zero_o = 0.3}, "cook_torrance", {{"f0", {0.05}}});
  EXPECT_GT(f.budget->beyond_first_order, 0u);
  EXPECT_THAT(testing::PrintToString(budget_in_words(f)), HasSubstr("is of first order"));
}

}  // namespace
}  // namespace brdf::fit
