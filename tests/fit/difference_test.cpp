// Tests the comparison of two tables: which error of an instrument explains a difference, and when nothing
// can be told.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "fit/between/difference_report.h"
#include "io/files/error.h"
#include "laboratories.h"

namespace brdf::fit {
namespace {

std::vector<TableToFit> pair_of(const Material& first, const Material& second, const LaboratoryErrors& errors,
                                std::uint64_t seed = 3) {
  std::mt19937_64 random(seed);
  return {{{laboratory(first, 0, {}, random, no_structure, "a.csv"), {}}, laboratory_options()},
          {{laboratory(second, 2.5, errors, random, no_structure, "b.csv"), {}}, laboratory_options()}};
}

const Explanation& explanation(const Comparison& c, Cause cause) {
  return *std::ranges::find(c.explanations, cause, &Explanation::cause);
}

TEST(Difference, CannotBeToldWithoutABudget) {
  for (const double alpha : {0.25, 0.27}) {  // equal and different surfaces
    const Comparison c = compare_tables(pair_of(gloss(), gloss(alpha), {.scale = 0.01}), laboratory_model());
    EXPECT_EQ(c.difference.sameness, Sameness::undecided);
    EXPECT_TRUE(answer(c.difference).starts_with("cannot be told: a common scale or angle error")) << alpha;
    EXPECT_EQ(directions_in_words(c.difference), "");
    const io::Json json = to_json(c);
    EXPECT_EQ(json["answer"], "cannot_be_told");
    EXPECT_FALSE(json.contains("p"));
    EXPECT_FALSE(json.contains("differing"));
    EXPECT_EQ(html_page(c, pair_of(gloss(), gloss(), {})).find("beyond the budgets"), std::string::npos);
  }
}

// Gives both tables the budget of a goniophotometer.
std::vector<TableToFit> with_budgets(std::vector<TableToFit> tables) {
  for (TableToFit& t : tables) t.samples.budget = budget_of(0.01, 0.15, 0.005);
  return tables;
}

TEST(Difference, OfEqualSurfacesIsWithinTheBudgets) {
  const LaboratoryErrors errors{.scale = 0.012, .zero_i = 0.15, .zero_o = -0.1};
  const std::vector<TableToFit> tables = with_budgets(pair_of(gloss(), gloss(), errors));
  const Comparison c = compare_tables(tables, laboratory_model());
  EXPECT_EQ(c.difference.sameness, Sameness::no_difference);
  EXPECT_TRUE(answer(c.difference).starts_with("no difference beyond the budgets (W "))
      << answer(c.difference);
  EXPECT_NE(directions_in_words(c.difference).find("beyond the budgets at 0 of "), std::string::npos);
  EXPECT_TRUE(c.difference.differing().empty());
  const io::Json json = to_json(c);
  EXPECT_EQ(json["answer"], "no_difference");
  EXPECT_EQ(json["differing"], io::Json::array());
  EXPECT_NE(html_page(c, tables).find("No difference beyond the budgets"), std::string::npos);
}

TEST(Difference, BeyondTheBudgetsNamesTheParameterAndTheDirections) {
  const std::vector<TableToFit> tables = with_budgets(pair_of(gloss(), gloss(0.27), {.scale = 0.01}));
  const Comparison c = compare_tables(tables, laboratory_model());
  EXPECT_EQ(c.difference.sameness, Sameness::different);
  EXPECT_EQ(c.difference.differing(), std::vector<std::string>{"alpha"});
  EXPECT_TRUE(answer(c.difference).starts_with("different beyond the budgets: alpha (+8"))
      << answer(c.difference);
  EXPECT_EQ(directions_in_words(c.difference).find(" at 0 of "), std::string::npos);
  EXPECT_FALSE(explanation(c, Cause::scale).explains);
  EXPECT_EQ(to_json(c)["differing"], io::Json::array({"alpha"}));
  // The band of all directions contains 0 wherever the parameters do not differ.
  for (const DirectionDifference& d : c.difference.directions)
    EXPECT_EQ(d.beyond, square(d.difference / d.uncertainty) > 7.8147);  // chi-square of three parameters
}

TEST(Difference, OfAScaleBeyondTheBudgetNamesTheWeights) {
  const Comparison c =
      compare_tables(with_budgets(pair_of(gloss(), gloss(), {.scale = 0.08})), laboratory_model());
  EXPECT_EQ(c.difference.sameness, Sameness::different);
  EXPECT_TRUE(explanation(c, Cause::scale).explains);
  EXPECT_NEAR(explanation(c, Cause::scale).size, 0.083, 0.002);
  EXPECT_NEAR(explanation(c, Cause::scale).stated, 0.01 * std::sqrt(2), 1e-12);  // of both tables
  EXPECT_NE(
      in_words(explanation(c, Cause::scale)).find(", 5.8 times its standard uncertainty by the budgets"),
      std::string::npos)
      << in_words(explanation(c, Cause::scale));
  const std::vector<std::string> names = c.difference.differing();
  EXPECT_NE(std::ranges::find(names, "kd[f_r]"), names.end());
  EXPECT_EQ(std::ranges::find(names, "alpha"), names.end());
}

TEST(Difference, OfExactValuesIsJudgedByTheirBudgets) {
  std::vector<TableToFit> tables = with_budgets(pair_of(gloss(), gloss(), {.scale = 0.01, .noise = 0}));
  EXPECT_EQ(compare_tables(tables, laboratory_model()).difference.sameness, Sameness::no_difference);
}

TEST(Difference, NeedsTheBudgetsOfBothTables) {
  std::vector<TableToFit> tables = with_budgets(pair_of(gloss(), gloss(), {}));
  tables[1].samples.budget = nullptr;
  try {
    compare_tables(tables, laboratory_model());
    FAIL();
  } catch (const InputError& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with("b.csv has no uncertainty budget, but a.csv has one"))
        << error.what();
  }
}

TEST(Difference, IsExplainedByTheScaleOfOneTable) {
  const Comparison c = compare_tables(pair_of(gloss(), gloss(), {.scale = 0.012}), laboratory_model());
  const Explanation& scale = explanation(c, Cause::scale);
  EXPECT_TRUE(scale.explains);
  EXPECT_EQ(scale.table, "b.csv");
  EXPECT_NEAR(scale.size, 0.012, 0.0015);
  EXPECT_FALSE(explanation(c, Cause::aperture).explains);
}

TEST(Difference, IsExplainedByAZeroErrorOfTheLightOrTheViewer) {
  const Comparison light =
      compare_tables(pair_of(gloss(), gloss(), {.zero_i = 0.6, .noise = 0.001}), laboratory_model());
  EXPECT_TRUE(explanation(light, Cause::zero_theta_i).explains);
  EXPECT_NEAR(explanation(light, Cause::zero_theta_i).size, 0.6, 0.1);
  const Comparison viewer =
      compare_tables(pair_of(gloss(), gloss(), {.zero_o = -0.6, .noise = 0.001}), laboratory_model());
  EXPECT_TRUE(explanation(viewer, Cause::zero_theta_o).explains);
  EXPECT_NEAR(explanation(viewer, Cause::zero_theta_o).size, -0.6, 0.1);
}

TEST(Difference, IsExplainedByAnApertureOfEitherTable) {
  const Material narrow = gloss(0.1);
  std::vector<TableToFit> tables = pair_of(narrow, narrow, {.aperture = 6});
  const Comparison c = compare_tables(tables, laboratory_model());
  EXPECT_TRUE(explanation(c, Cause::aperture).explains);
  EXPECT_EQ(explanation(c, Cause::aperture).table, "b.csv");
  EXPECT_NEAR(explanation(c, Cause::aperture).size, 6, 0.6);
  std::swap(tables[0], tables[1]);
  const Comparison swapped = compare_tables(tables, laboratory_model());
  EXPECT_EQ(explanation(swapped, Cause::aperture).table, "b.csv");
  EXPECT_NEAR(explanation(swapped, Cause::aperture).size, 6, 0.6);
}

TEST(Difference, OfAWidthIsExplainedByNoScale) {
  const Comparison c = compare_tables(pair_of(gloss(), gloss(0.27), {}), laboratory_model());
  EXPECT_FALSE(explanation(c, Cause::scale).explains);
  EXPECT_NE(in_words(explanation(c, Cause::scale)).find("not explained by a scale error of "),
            std::string::npos);
}

// The size beyond the limit is no stop of the search, and a step on the way to it is not reported.
TEST(Difference, IsExplainedByASizeUpToTheLimitAndByNoStepOnTheWay) {
  const auto scale_of = [](double factor) {
    return compare_tables(with_budgets(pair_of(gloss(), gloss(), {.scale = std::log(factor)})),
                          laboratory_model());
  };
  for (const double factor : {0.55, 0.6, 1.45}) {
    const Comparison c = scale_of(factor);
    EXPECT_TRUE(explanation(c, Cause::scale).explains) << factor;
    EXPECT_NEAR(explanation(c, Cause::scale).size, factor - 1, 0.03);
  }
  for (const double factor : {0.3, 2.0, 10.0}) {
    const Comparison c = scale_of(factor);
    EXPECT_EQ(in_words(explanation(c, Cause::scale)), "not explained by a scale error up to 50 %") << factor;
    EXPECT_TRUE(to_json(c)["explanations"][0]["size"].is_null());
  }
}

TEST(Difference, WithinTheScatterNeedsNoExplanation) {
  const Comparison c = compare_tables(pair_of(gloss(), gloss(), {}), laboratory_model());
  EXPECT_GT(c.difference.probability, 0.05);
  EXPECT_TRUE(c.explanations.empty());
}

// Errors that all channels share leave the differences between channels to the
// scatter alone, with a source of rows and without one.
TEST(Difference, OfEqualSpectraIsRarelyAnAlarm) {
  constexpr int kPairs = 12;
  for (const std::size_t channels : {3, 8})
    for (const double stated : {0.005, 0.0}) {
      int alarms = 0;
      for (int k = 0; k < kPairs; ++k) {
        std::mt19937_64 random(std::uint64_t(100 + k));
        std::vector<TableToFit> tables;
        for (const double first_view : {0.0, 2.5})
          tables.push_back(
              {{laboratory(spectral(channels), first_view, drawn_errors(0.01, 0.15, 0.005, random), random),
                {},
                budget_of(0.01, 0.15, stated)},
               laboratory_options()});
        const Difference d = difference_of(fit_tables(tables, laboratory_model()), tables);
        EXPECT_EQ(d.obstacle, "");
        alarms += d.sameness == Sameness::different;
      }
      EXPECT_LE(alarms, 3) << channels << " channels, repeatability " << stated;
    }
}

// Without a known noise nothing shows whether the form describes a table.
TEST(Difference, StatesThatALackOfFitIsNotSeenIfTheNoiseIsUnknown) {
  const std::vector<TableToFit> tables = with_budgets(pair_of(gloss(), gloss(), {}));
  Difference d = compare_tables(tables, laboratory_model()).difference;
  ASSERT_EQ(d.sameness, Sameness::no_difference);
  EXPECT_EQ(answer(d).find("is not known"), std::string::npos) << answer(d);
  d.fits.tables[0].fit.lack_of_fit.residual_over_scatter.reset();
  EXPECT_NE(answer(d).find("; the noise of a.csv is not known, so that a lack of fit is not seen"),
            std::string::npos)
      << answer(d);
}

Material brushed(double along, double across) {
  Material m = make_material(*find_form("ward"), {"f_r"});
  const ReflectanceInfo& about = m.terms[0].form.info();
  for (std::size_t k = 0; k < about.shape.size(); ++k)
    m.terms[0].shape[0][k] = about.shape[k].name == "alpha_x" ? along : across;
  return m;
}

// A table with lights at three azimuths, at which a brushed surface looks different.
io::SampleTable at_three_azimuths(const Material& surface, double first_view, std::mt19937_64& random) {
  io::SampleTable table;
  table.set_channels(surface.channels);
  std::normal_distribution<double> normal;
  std::vector<double> f(1);
  for (const double turn : {0, 45, 90})
    for (const double light : {10, 30, 50})
      for (const double phi : {0, 180})
        for (double view = first_view; view < 75; view += 5) {
          eval(surface, direction(degrees(light), degrees(180 + turn)),
               direction(degrees(view), degrees(phi + turn)), f);
          table.add_directions(light, 180 + turn, view, phi + turn);
          table.values[0].push_back(f[0] * std::exp(0.005 * normal(random)));
        }
  return table;
}

// An isotropic form has the same parameters for a brushed surface and for the same surface turned.
TEST(Difference, ThatTheFormCannotDescribeIsSeenInTheValuesOrNotDenied) {
  const std::vector<std::vector<Reflectance>> ward{{*find_form("ward")}};
  const auto compared = [&](double along, double across, double first_view) {
    std::mt19937_64 random(5);
    std::vector<TableToFit> tables;
    for (const Material& m : {brushed(0.1, 0.25), brushed(along, across)})
      tables.push_back(
          {{at_three_azimuths(m, tables.empty() ? 0 : first_view, random), {}, budget_of(0.005, 0.02, 0.005)},
           laboratory_options()});
    for (TableToFit& t : tables) t.options.fix.clear();
    tables[0].samples.table.source = "a.csv";
    return compare_tables(tables, ward);
  };
  const Comparison turned = compared(0.25, 0.1, 0), same = compared(0.1, 0.25, 0),
                   elsewhere = compared(0.25, 0.1, 2.5);
  ASSERT_TRUE(turned.difference.obstacle.empty()) << turned.difference.obstacle;
  EXPECT_GT(turned.difference.probability, 0.05);
  EXPECT_EQ(turned.difference.sameness, Sameness::different);
  EXPECT_NE(answer(turned.difference).find(" values at the same directions (W "), std::string::npos)
      << answer(turned.difference);
  EXPECT_NE(values_in_words(turned.difference).find("; most clearly at theta_i, phi_i"), std::string::npos);
  EXPECT_GT(to_json(turned)["common_values"]["beyond"].get<int>(), 20);
  EXPECT_EQ(same.difference.sameness, Sameness::no_difference);
  EXPECT_EQ(same.difference.common->beyond, 0u);
  EXPECT_EQ(elsewhere.difference.sameness, Sameness::undecided);
  EXPECT_NE(
      answer(elsewhere.difference).find("undecided: ward describes a.csv only roughly: its residuals are "),
      std::string::npos)
      << answer(elsewhere.difference);
  EXPECT_EQ(to_json(elsewhere)["answer"], "undecided");
}

TEST(Difference, IsUndecidedForAParameterAtItsBound) {
  std::vector<TableToFit> tables = pair_of(gloss(), gloss(), {});
  tables[1].options.bounds = {{"alpha", 0.26, 0.5}};
  const Comparison c = compare_tables(tables, laboratory_model());
  EXPECT_TRUE(answer(c.difference).starts_with("undecided: alpha is at its bound for b.csv"))
      << answer(c.difference);
  EXPECT_TRUE(c.explanations.empty());
  EXPECT_EQ(to_json(c)["answer"], "undecided");
}

TEST(Difference, IsUndecidedForAFormThatDoesNotDescribeATable) {
  std::vector<TableToFit> tables = pair_of(gloss(0.1), gloss(0.1), {});
  for (TableToFit& t : tables) t.options.fix.clear();
  const Comparison c = compare_tables(tables, {{*find_form("lambert")}});
  EXPECT_EQ(c.difference.sameness, Sameness::undecided);
  EXPECT_NE(answer(c.difference).find("lambert does not describe"), std::string::npos)
      << answer(c.difference);
}

TEST(Difference, IsUndecidedForValuesWithoutScatter) {
  std::mt19937_64 random(1);
  const LaboratoryErrors exact{.noise = 0};
  std::vector<TableToFit> tables{{{laboratory(gloss(), 0, exact, random), {}}, laboratory_options()},
                                 {{laboratory(gloss(), 2.5, exact, random), {}}, laboratory_options()}};
  EXPECT_TRUE(answer(compare_tables(tables, laboratory_model()).difference).starts_with("undecided: "));
}

TEST(Difference, TakesTheFormThatIsRecommendedForBothTables) {
  std::vector<TableToFit> tables = pair_of(gloss(), gloss(), {});
  for (TableToFit& t : tables) t.options.fix.clear();
  const Comparison c = compare_tables(tables, {{*find_form("lambert")}, {*find_form("cook_torrance")}});
  EXPECT_EQ(c.difference.fits.form, "cook_torrance");
}

TEST(Difference, ComparesAParameterThatMayBe0InItsOwnUnit) {
  const Material metal = gloss(0.25, 1e-5, 1, 0.9);
  std::vector<TableToFit> tables = pair_of(metal, metal, {});
  for (TableToFit& t : tables) t.options.fix = {{"ks", {1}}};
  const Comparison c = compare_tables(tables, laboratory_model());
  for (const ParameterDifference& p : c.difference.parameters)
    EXPECT_EQ(p.logarithmic, p.name != "kd[f_r]") << p.name;
}

TEST(Remainder, IsWhatAChangeLeaves) {
  Matrix covariance(2, 2);
  covariance(0, 0) = 4;
  covariance(1, 1) = 1;
  EXPECT_NEAR(*quadratic_form({2, 3}, covariance), 10, 1e-12);
  const Remainder r = remainder_without({2, 3}, covariance, {0, 2}, 1e6);
  EXPECT_NEAR(r.size, 1.5, 1e-12);
  EXPECT_NEAR(r.statistic, 1, 1e-12);
  EXPECT_NEAR(r.probability, 0.3173, 1e-4);  // chi-square with one degree of freedom
  covariance(0, 0) = 0;
  EXPECT_FALSE(quadratic_form({2, 3}, covariance));
}

}  // namespace
}  // namespace brdf::fit
