// Tests the map of residuals: its cells, their means, and the omission of rows in large tables.
#include "measured/residual_map.h"

#include <gtest/gtest.h>

#include <cmath>

#include "io/samples/degrees.h"
#include "measured/counterparts.h"
#include "tests/measured/samples.h"

namespace brdf::measured {
namespace {

std::size_t cell(double theta_h, double theta_d) {
  return std::size_t(theta_d / 2) * ResidualMap::kCells + std::size_t(theta_h / 2);
}

TEST(ResidualMap, IsZeroForTheTruthAndTheLogarithmOfAFactor) {
  const Material truth = lobes({{0.2, 0.5, 0.2}});
  const io::SampleTable table = scanned(truth, {0, 30, 60}, 0);
  const ResidualMap map(table);
  std::size_t known = 0;
  for (const double v : map.cells(truth)) {
    if (std::isnan(v)) continue;
    EXPECT_NEAR(v, 0, 1e-9);
    ++known;
  }
  EXPECT_GT(known, 100u);
  Material bright = truth;
  const std::size_t kd = std::size_t(info(truth.terms[0].form).weight_index(Role::diffuse));
  const std::size_t ks = std::size_t(info(truth.terms[0].form).weight_index(Role::specular));
  bright.terms[0].weights[0][kd] *= 1.25;
  bright.terms[0].weights[0][ks] *= 1.25;
  for (const double v : map.cells(bright))
    if (!std::isnan(v)) {
      EXPECT_NEAR(v, std::log(1.25), 1e-9);
    }
}

TEST(ResidualMap, PutsARowWhereItsHalfVectorLies) {
  io::SampleTable table;
  table.channels = {"f"};
  table.values.resize(1);
  const auto add = [&](double ti, double to, double phi_o, double value) {
    table.add_directions(ti, 0, to, phi_o);
    table.values[0].push_back(value);
  };
  add(41, 41, 180, 2);  // the mirror direction: theta_h 0, theta_d 41
  add(31, 31, 0, 4);    // back towards the light: theta_h 31, theta_d 0
  add(70, 11, 0, 0);    // no entry: a value of 0 has no logarithm
  const Material one = make_material(*find_form("lambert"), {"f"});
  std::vector<double> f(1);
  eval(one, io::unit_vector(41, 0), io::unit_vector(41, 180), f);
  const std::vector<double> cells = ResidualMap(table).cells(one);
  EXPECT_NEAR(cells[cell(0.1, 41)], std::log(f[0] / 2), 1e-12);
  EXPECT_NEAR(cells[cell(31, 0.1)], std::log(f[0] / 4), 1e-12);
  EXPECT_EQ(std::count_if(cells.begin(), cells.end(), [](double v) { return !std::isnan(v); }), 2);
}

TEST(ResidualMap, OfFewRowsKeepsEveryCellAndIsAlwaysTheSame) {
  const Material truth = lobes({{0.2, 0.5, 0.2}}), other = lobes({{0.2, 0.5, 0.25}});
  const io::SampleTable table = scanned(truth, {0, 15, 30, 45, 60, 75}, 0, {0}, 2);
  const ResidualMap all(table), few(table, 3000);
  ASSERT_GT(table.rows(), 6000u);
  EXPECT_EQ(all.directions().count, table.rows());
  EXPECT_LE(few.directions().count, 3000u);
  EXPECT_GT(few.directions().count, 1500u);
  const std::vector<double> a = all.cells(other), b = few.cells(other);
  double largest = 0, apart = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    ASSERT_EQ(std::isnan(a[k]), std::isnan(b[k])) << k;
    if (std::isnan(a[k])) continue;
    largest = std::max(largest, std::abs(a[k]));
    apart = std::max(apart, std::abs(a[k] - b[k]));
  }
  EXPECT_LT(apart, 0.25 * largest);
  const std::vector<double> again = ResidualMap(table, 3000).cells(other);
  for (std::size_t k = 0; k < b.size(); ++k) EXPECT_TRUE(b[k] == again[k] || std::isnan(b[k])) << k;
}

TEST(ResidualMap, ChannelsFindTheirCounterparts) {
  using Names = std::vector<std::string>;
  EXPECT_EQ(counterparts({"b", "g", "r"}, {"r", "g", "b"}), (std::vector<int>{2, 1, 0}));
  EXPECT_EQ(counterparts({"465nm", "525nm", "625nm"}, {"r", "g", "b"}), (std::vector<int>{2, 1, 0}));
  EXPECT_EQ(counterparts({"x", "y"}, {"f"}), (std::vector<int>{0, 0}));
  EXPECT_EQ(counterparts({"x", "y"}, Names{"r", "g"}), (std::vector<int>{-1, -1}));
}

}  // namespace
}  // namespace brdf::measured
