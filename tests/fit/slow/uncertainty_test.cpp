// Tests the coverage of 95 % intervals, and the effect of outliers on a fit of two lobes.
#include <gtest/gtest.h>

#include <iostream>
#include <map>
#include <random>

#include "../samples.h"
#include "fit/assess/assess.h"
#include "fit/solve/minima.h"

namespace brdf::fit {
namespace {

struct Family {
  const char* form;
  std::vector<double> shape, weights;
};

class Coverage : public ::testing::TestWithParam<Family> {};

// For 2,000 replicates of value * exp(0.05 z - 0.00125), the interval must hold the truth 92 to 98 % of the
// time.
TEST_P(Coverage, OfNominal95IntervalsIs92To98Percent) {
  constexpr int kReplicates = 2000;
  const Family family = GetParam();
  Material truth = make_material(*find_form(family.form), {"f"});
  truth.terms[0].shape[0] = family.shape;
  truth.terms[0].weights[0] = family.weights;
  synth::Instrument instrument;
  FitOptions options;
  options.aperture = 0;
  const io::SampleTable exact = synth::measure(truth, instrument);
  FitData data = prepare(exact, options);
  ASSERT_GT(data.rows(), 2000u);
  ASSERT_LT(data.rows(), 3000u);
  const std::vector<double> clean = data.values[0];
  const Model model({truth.terms[0].form}, data.channels, options);
  const std::vector<double> start = find_minima(data, model, {}, options).minima.front().p;
  std::mt19937_64 random(11);
  std::normal_distribution<double> normal;
  struct Counts {
    int inside = 0, identified = 0;
    double sum = 0, square = 0, error = 0;
  };
  std::map<std::string, Counts> covered;
  for (int k = 0; k < kReplicates; ++k) {
    for (std::size_t j = 0; j < clean.size(); ++j)
      data.values[0][j] = clean[j] * std::exp(0.05 * normal(random) - 0.00125);
    const SampleStream stream(data, model, {}, 0);
    SolveOptions solver;
    const Solution s = refine(stream, start, solver);
    ASSERT_EQ(s.termination, Termination::converged);
    if (k % 100 == 0) {  // a start at the truth leads to the same minimum as the grid of starting points
      const SearchResult grid = find_minima(data, model, {}, options);
      ASSERT_NEAR(grid.minima.front().cost / s.cost, 1, 1e-9);
    }
    const Minimum m{s.p, s.cost, 1, s.at_bound, s.termination, s.message};
    for (const Estimate& e : uncertainty(stream, m).estimates) {
      if (e.status != Status::free || e.name == "alpha_y") continue;
      const auto& f = info(truth.terms[0].form);
      const int shape = f.shape_index(e.name), weight = f.weight_index(e.name);
      const double value =
          shape >= 0 ? family.shape[std::size_t(shape)] : family.weights[std::size_t(weight)];
      Counts& c = covered[e.name];
      c.inside += e.low <= value && value <= e.high;
      ++c.identified;
      c.sum += e.value - value, c.square += (e.value - value) * (e.value - value);
      c.error += e.standard_error;
    }
  }
  for (const auto& [name, c] : covered) {
    const double n = c.identified, share = c.inside / n, bias = c.sum / n;
    const double deviation = std::sqrt(c.square / n - bias * bias);
    std::cout << "[ coverage ] " << family.form << " " << name << ": " << 100 * share << " % of "
              << c.identified << " replicates; bias " << bias / deviation
              << " standard deviations, standard error " << c.error / n / deviation << " of the deviation\n";
    EXPECT_GE(share, 0.92) << name;
    EXPECT_LE(share, 0.98) << name;
    EXPECT_EQ(c.identified, kReplicates) << name;
  }
  EXPECT_EQ(covered.size(), family.weights.size() + (family.shape.empty() ? 0u : 1u));
}
INSTANTIATE_TEST_SUITE_P(Slow, Coverage,
                         ::testing::Values(Family{"ward", {0.15, 0.15}, {0.3, 0.2}},
                                           Family{"cook_torrance", {0.25, 0.25}, {0.2, 0.8, 0.3}},
                                           Family{"oren_nayar", {0.5}, {0.6}}),
                         [](const auto& p) { return std::string(p.param.form); });

// The lobes have alpha 0.05 and 0.4, and 2.5 % of the values are five times too large. At least 38 of 40
// random starting points must lead to 0.05.
TEST(TwoLobes, AreFoundAmongOutliersFromNearlyEveryStart) {
  Material truth = make_material(*find_form("ward"), {"f"});
  truth.terms.push_back(make_term(*find_form("ward"), 1));
  truth.terms[0].shape[0] = {0.05, 0.05}, truth.terms[1].shape[0] = {0.4, 0.4};
  truth.terms[0].weights[0] = {0.2, 0.1}, truth.terms[1].weights[0] = {0, 0.3};
  synth::Instrument instrument;
  instrument.grid.parts = {"hemisphere", "in_plane"};
  instrument.noise = 0.05;
  io::SampleTable table = synth::measure(truth, instrument);
  std::mt19937_64 random(5);
  for (double& v : table.values[0])
    if (random() % 1000 < 25) v *= 5;
  FitOptions options;
  options.aperture = 0;
  options.grid_starts = false;
  options.random_starts = 40;
  const FitData data = prepare(table, options);
  const Model model(forms({"ward", "ward"}), data.channels, options);
  int found = 0;
  for (const Minimum& m : find_minima(data, model, {}, options).minima) {
    const double alpha = model.shape(m.p, 0, 0)[0];
    std::cout << "[ two lobes ] alpha " << alpha << " and " << model.shape(m.p, 1, 0)[0] << ", cost "
              << m.cost << ", from " << m.basin << " starts\n";
    if (std::abs(alpha / 0.05 - 1) < 0.05) found += m.basin;
  }
  EXPECT_GE(found, 38);
}

}  // namespace
}  // namespace brdf::fit
