// Tests the consensus of laboratories against hand-calculated values, and how often its interval holds the
// truth.
#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <random>

#include "fit/assess/student.h"
#include "fit/between/mandel_paule.h"
#include "fit/between/round_robin.h"
#include "io/files/error.h"
#include "laboratories.h"

namespace brdf::fit {
namespace {

TEST(Consensus, OfTwoEqualUncertaintiesIsTheMean) {
  // The squared deviations are 1 + 1; they add up to n - 1 = 1 at 1 + tau^2 = 2.
  const std::vector<LaboratoryValue> values{{0, 1}, {2, 1}};
  const Consensus c = consensus_of(values);
  EXPECT_NEAR(c.value, 1, 1e-12);
  EXPECT_NEAR(c.between, 1, 1e-12);
  EXPECT_NEAR(c.uncertainty, 1, 1e-12);
  EXPECT_NEAR(c.half_width, 12.7062, 1e-4);
  EXPECT_NEAR(c.chi_square, 2, 1e-12);
  ASSERT_EQ(c.degrees.size(), 2u);
  EXPECT_NEAR(c.degrees[0].difference, -1, 1e-12);
  EXPECT_NEAR(c.degrees[0].uncertainty, 1, 1e-12);  // 1 + 1 - 1
  EXPECT_FALSE(c.degrees[0].is_far());
}

TEST(Consensus, HasNothingBetweenLaboratoriesThatAgreeWithinTheirUncertainties) {
  const std::vector<LaboratoryValue> values{{0, 1}, {1, 1}};
  const Consensus c = consensus_of(values);
  EXPECT_EQ(c.between, 0);
  EXPECT_NEAR(c.uncertainty, std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(c.chi_square, 0.5, 1e-12);
  EXPECT_NEAR(c.probability, 0.4795, 1e-4);
  EXPECT_NEAR(c.degrees[1].uncertainty, std::sqrt(0.5), 1e-12);  // without tau: u_j^2 - u(m)^2
}

TEST(Consensus, GivesTheNumbersOfARoundRobinOfSixLaboratories) {
  // ln f(0:45) of six laboratories in per cent, from 0.13302, with the scale uncertainties that they state.
  const std::vector<LaboratoryValue> values{{2.463, 0.4}, {1.672, 0.6}, {1.228, 0.8},
                                            {0.143, 1},   {0.486, 1.2}, {-0.097, 2}};
  const Consensus c = consensus_of(values);
  EXPECT_NEAR(c.value, 1.533, 0.002);
  EXPECT_NEAR(c.between, 0.509, 0.001);
  EXPECT_NEAR(c.uncertainty, 0.385, 0.001);
  EXPECT_NEAR(c.half_width, 0.991, 0.001);
  const std::vector<double> degrees{0.93, 0.14, -0.305, -1.39, -1.047, -1.63};
  for (std::size_t k = 0; k < degrees.size(); ++k) EXPECT_NEAR(c.degrees[k].difference, degrees[k], 0.002);
}

TEST(Consensus, SolvesItsEquationForUncertaintiesOfDifferentSizes) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  for (int run = 0; run < 200; ++run) {
    std::vector<LaboratoryValue> values;
    for (int k = 0; k < 7; ++k) values.push_back({10 * normal(random), std::exp(3 * normal(random))});
    const Consensus c = consensus_of(values);
    double sum = 0;
    for (const LaboratoryValue& v : values)
      sum += square(v.value - c.value) / (square(v.uncertainty) + square(c.between));
    if (c.between > 0)
      EXPECT_NEAR(sum, 6, 1e-9);
    else
      EXPECT_LE(sum, 6);
  }
}

// The share of round robins in which intervals hold the truth 0, in per cent.
struct Coverage {
  double student = 0, normal = 0;  // with Student's t and with 1.96
};

Coverage coverage_of(int laboratories, double tau, int runs, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> size(std::log(0.3), std::log(1.5));
  Coverage out;
  for (int run = 0; run < runs; ++run) {
    std::vector<LaboratoryValue> values;
    for (int k = 0; k < laboratories; ++k) {
      const double u = std::exp(size(random));
      values.push_back({std::hypot(u, tau) * normal(random), u});
    }
    const Consensus c = consensus_of(values);
    out.student += 100.0 / runs * (std::abs(c.value) <= c.half_width);
    out.normal += 100.0 / runs * (std::abs(c.value) <= 1.96 * c.uncertainty);
  }
  return out;
}

TEST(Consensus, HoldsTheTruthIn95PercentOfRoundRobins) {
  constexpr int kRuns = 4000;  // know a coverage to 0.35 %
  for (const int laboratories : {4, 6, 10}) {
    const Coverage c = coverage_of(laboratories, 1, kRuns, 1);
    EXPECT_GE(c.student, 93) << laboratories << " laboratories";
    EXPECT_LE(c.student, 97) << laboratories << " laboratories";
    std::cout << laboratories << " laboratories: " << c.student << " %, with 1.96 " << c.normal << " %\n";
    EXPECT_LT(c.normal, 92.5) << "Student's t is not needed for " << laboratories;
  }
  EXPECT_GE(coverage_of(6, 0, kRuns, 1).student, 97);  // tau 0 is not known, so that the interval is wider
}

TEST(Consensus, RefusesAnUncertaintyOf0AndASingleValue) {
  const std::vector<LaboratoryValue> exact{{0, 1}, {1, 0}}, single{{0, 1}};
  EXPECT_THROW(consensus_of(exact), std::logic_error);
  EXPECT_THROW(consensus_of(single), std::logic_error);
}

TEST(QuadraticForm, HasTheTablesQuantiles) {
  EXPECT_NEAR(quadratic_tail(7.814728, 3, 1e6), 0.05, 1e-7);
  EXPECT_NEAR(quadratic_quantile(3, 1e6), 7.814728, 1e-6);
  EXPECT_NEAR(quadratic_quantile(3, 20) / 3, 3.098391, 1e-6);  // Fisher's F
  EXPECT_NEAR(quadratic_tail(56.9, 3, 1e6), 2.7e-12, 0.1e-12);
}

std::vector<TableToFit> round_robin_tables(const std::vector<double>& scales, double noise = 0.005) {
  std::mt19937_64 random(7);
  std::vector<TableToFit> tables;
  for (std::size_t k = 0; k < scales.size(); ++k)
    tables.push_back({{laboratory(gloss(), 0.5 * double(k), {.scale = scales[k], .noise = noise}, random,
                                  no_structure, "lab_" + std::to_string(k + 1) + ".csv"),
                       {}},
                      laboratory_options()});
  return tables;
}

const RoundRobinQuantity& quantity(const RoundRobin& result, const std::string& name) {
  for (const RoundRobinQuantity& q : result.quantities)
    if (q.name == name) return q;
  throw std::runtime_error("no quantity " + name);
}

TEST(RoundRobin, PutsScaleErrorsBetweenLaboratoriesWhereTablesHaveNoBudget) {
  std::vector<TableToFit> tables = round_robin_tables({-0.01, 0, 0.01, 0.02});
  const RoundRobin result = round_robin(fit_tables(tables, laboratory_model()), {{{}, {30, 30, 180}}, {8}});
  EXPECT_TRUE(result.is_decided());
  EXPECT_FALSE(result.fits.have_budgets());
  // The standard deviation of the scales is 1.29 %.
  const RoundRobinQuantity& f = quantity(result, "f(0:45)");
  EXPECT_NEAR(f.consensus->between, 0.0129, 0.0005);
  EXPECT_NEAR(f.consensus->value, f.values[1].value + 0.005, 0.001);
  EXPECT_NEAR(quantity(result, "kd[f_r]").consensus->between, 0.0129, 0.001);
  EXPECT_LT(quantity(result, "alpha").consensus->between, 0.003);  // a scale does not move the width
  EXPECT_TRUE(quantity(result, "f(30:30)").consensus);
  const RoundRobinQuantity& albedo = quantity(result, "albedo(8)");
  EXPECT_NEAR(albedo.consensus->between, 0.0129, 0.0005);
  EXPECT_NEAR(albedo.natural[0], 0.43664 * std::exp(-0.01),
              0.001);  // of brdf albedo, and the scale of the table
}

TEST(RoundRobin, HasNothingBetweenLaboratoriesWithinTheirBudgets) {
  std::vector<TableToFit> tables = round_robin_tables({-0.01, 0, 0.01, 0.02});
  for (TableToFit& t : tables) t.samples.budget = budget_of(0.02, 0.1, 0.005);
  const RoundRobin result = round_robin(fit_tables(tables, laboratory_model()), {{{}}, {}});
  EXPECT_TRUE(result.fits.have_budgets());
  const RoundRobinQuantity& f = quantity(result, "f(0:45)");
  EXPECT_EQ(f.consensus->between, 0);
  for (const LaboratoryValue& v : f.values) EXPECT_NEAR(v.uncertainty, 0.02, 0.002);  // not over root n
  EXPECT_NEAR(f.consensus->uncertainty, 0.01, 0.001);
}

TEST(RoundRobin, NamesTheTableWhoseParameterIsAtItsBound) {
  std::vector<TableToFit> tables = round_robin_tables({0, 0.01, 0.02});
  tables[1].options.bounds = {{"alpha", 0.26, 0.5}};
  const RoundRobin result = round_robin(fit_tables(tables, laboratory_model()), {{{}}, {}});
  const RoundRobinQuantity& alpha = quantity(result, "alpha");
  EXPECT_FALSE(alpha.consensus);
  EXPECT_EQ(alpha.obstacle, "alpha is at its bound for lab_2.csv");
  EXPECT_FALSE(result.is_decided());
  EXPECT_TRUE(quantity(result, "f(0:45)").consensus);
}

TEST(RoundRobin, IsUndecidedForValuesWithoutAnyScatter) {
  std::vector<TableToFit> tables = round_robin_tables({0, 0.01, 0.02}, 0);
  const RoundRobin result = round_robin(fit_tables(tables, laboratory_model()), {{{}}, {}});
  EXPECT_FALSE(result.is_decided());
  for (const RoundRobinQuantity& q : result.quantities) EXPECT_FALSE(q.consensus) << q.name;
}

TEST(RoundRobin, RefusesTablesWithDifferentChannels) {
  std::vector<TableToFit> tables = round_robin_tables({0, 0.01});
  tables[1].samples.table.channels = {"532"};
  EXPECT_THROW(fit_tables(tables, laboratory_model()), InputError);
  tables.resize(1);
  EXPECT_THROW(fit_tables(tables, laboratory_model()), InputError);
}

TEST(AskedDirections, AreReadAndWritten) {
  EXPECT_EQ(to_text(asked_directions("--at", "0:45")), "0:45");
  EXPECT_EQ(to_text(asked_directions("--at", "30:10:90")), "30:10:90");
  EXPECT_EQ(asked_directions("--at", "30:10").phi, 180);
  for (const char* wrong : {"", "45", "a:b", "0:45:0:0", "0:90", "-5:45", "0:", "0:45:"})
    EXPECT_THROW(asked_directions("--at", wrong), InputError) << wrong;
}

}  // namespace
}  // namespace brdf::fit
