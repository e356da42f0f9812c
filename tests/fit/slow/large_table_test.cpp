// Tests that the ranking of a large table equals the ranking by all rows.
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

#include "../samples.h"
#include "fit/report/report.h"

namespace brdf::fit {
namespace {

// Returns 20 incidences with 7,280 viewers each. The lobe has alpha 0.02, and few viewers see it.
io::SampleTable large_table() {
  io::SampleTable t;
  for (int i = 0; i < 20; ++i)
    for (int ring = 0; ring < 80; ++ring)
      for (int sector = 0; sector < 91; ++sector)
        t.add_directions(2 + 3.9 * i, 180, 0.99 * ring + 0.3, 2 * sector);
  t.channels = {"f"};
  t.sigma.resize(1);
  Material m = make_material(*find_form("cook_torrance"), {"f"});
  m.terms[0].shape[0] = {0.02, 0.02};
  m.terms[0].weights[0] = {0.3, 0.6, 0.3};
  const DirectionArrays<double> arrays = io::unit_directions(t);
  std::mt19937_64 random(4);
  std::normal_distribution<double> normal;
  std::vector<double> f(1);
  t.values.resize(1);
  for (std::size_t k = 0; k < t.theta_i.size(); ++k) {
    eval(m, arrays.view().wi(k), arrays.view().wo(k), f);
    t.values[0].push_back(f[0] * std::exp(0.03 * normal(random)));
  }
  return t;
}

TEST(LeftOut, ALargeTableRanksItsOwnFamilyFirstInAnyOrder) {
  const io::SampleTable table = large_table();
  ASSERT_EQ(table.rows(), 145600u);
  io::SampleTable shuffled = table;
  std::vector<std::size_t> order(table.rows());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::mt19937_64 random(5);
  std::shuffle(order.begin(), order.end(), random);
  for (std::size_t k = 0; k < order.size(); ++k) {
    shuffled.theta_i[k] = table.theta_i[order[k]], shuffled.phi_i[k] = table.phi_i[order[k]];
    shuffled.theta_o[k] = table.theta_o[order[k]], shuffled.phi_o[k] = table.phi_o[order[k]];
    shuffled.values[0][k] = table.values[0][order[k]];
  }
  const FitResult result = fit(table, canonical_models(), {});
  EXPECT_EQ(result.ranking[0].form, "cook_torrance");
  EXPECT_EQ(result.ranking[0].verdict, Verdict::converged);
  EXPECT_GT(result.ranking[1].left_out->value, 50 * result.ranking[0].left_out->value);
  EXPECT_EQ(to_json(result, table, {})["ranking"],
            to_json(fit(shuffled, canonical_models(), {}), shuffled, {})["ranking"]);
}

}  // namespace
}  // namespace brdf::fit
