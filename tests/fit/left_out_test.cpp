// Tests the held-out error, the paired test between forms, and the ranking that is based on both.
#include <gtest/gtest.h>

#include <numeric>
#include <random>

#include "fit/assess/left_out.h"
#include "fit/assess/paired.h"
#include "fit/assess/select.h"
#include "fit/report/report.h"
#include "fit/solve/minima.h"
#include "samples.h"

namespace brdf::fit {
namespace {

Material gloss(double alpha) {
  Material m = make_material(*find_form("cook_torrance"), {"f"});
  m.terms[0].shape[0] = {alpha, alpha};
  m.terms[0].weights[0] = {0.8, 1, 0.04};
  return m;
}

// Returns the rows with the numbers in `keep`, from a table without sigmas.
io::SampleTable rows_of(const io::SampleTable& table, const std::vector<std::size_t>& keep) {
  io::SampleTable out = table;
  const auto pick = [&keep](auto& column) {
    auto all = column;
    column.clear();
    for (std::size_t k : keep) column.push_back(all[k]);
  };
  for (auto* column : {&out.theta_i, &out.phi_i, &out.theta_o, &out.phi_o}) pick(*column);
  for (auto& column : out.values) pick(column);
  out.lines.clear();
  return out;
}

io::SampleTable shuffled(const io::SampleTable& table) {
  std::vector<std::size_t> order(table.rows());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::mt19937_64 random(5);
  std::shuffle(order.begin(), order.end(), random);
  return rows_of(table, order);
}

TEST(LeftOut, IsThePredictionOfAFitWithoutTheIncidence) {
  const io::SampleTable table = measured(gloss(0.15), {"hemisphere"}, 0.03);
  const FitResult result = fit(table, {forms({"ward"})}, {});
  ASSERT_EQ(result.groups.groups.size(), 5u);
  const LeftOut& left_out = *result.ranking[0].left_out;
  double all = 0;
  for (std::size_t g = 0; g < 5; ++g) {
    const RowGroup& group = result.groups.groups[g];
    std::vector<std::size_t> kept, held;
    for (std::size_t k = 0; k < table.rows(); ++k)
      if (table.theta_o[k] <= 80)
        (std::abs(table.theta_i[k] - group.theta) < 1e-9 ? held : kept).push_back(k);
    ASSERT_EQ(held.size(), group.range.rows);
    const Material material = fit_one(rows_of(table, kept), {"ward"}).material;
    const io::SampleTable left = rows_of(table, held);
    const DirectionArrays<double> arrays = io::unit_directions(left);
    std::vector<double> f(1);
    double sum = 0;
    for (std::size_t k = 0; k < left.rows(); ++k) {
      const Vec3<double> wi = arrays.view().wi(k);
      eval(material, wi, arrays.view().wo(k), f);
      sum += std::pow(std::log1p(f[0] * wi.z) - std::log1p(left.values[0][k] * wi.z), 2);
    }
    EXPECT_NEAR(left_out.by_group[g] / (sum / double(left.rows())), 1, 2e-3) << group.theta;
    all += sum;
  }
  EXPECT_NEAR(left_out.value / (all / double(result.rows)), 1, 2e-3);
}

TEST(LeftOut, WhatStoodStillIsLeftOutWhetherLightOrViewer) {
  io::SampleTable table;
  for (int i = 1; i <= 80; ++i)
    for (int o : {15, 20, 30, 40, 45, 50, 60, 70, 80}) table.add_directions(i, 180, o, 0);
  const auto groups_of = [](const io::SampleTable& t) {
    const DirectionArrays<double> arrays = io::unit_directions(t);
    return group_rows(arrays.view(), t.rows());
  };
  const RowGroups scanned_light = groups_of(table);
  EXPECT_TRUE(scanned_light.by_viewer);
  EXPECT_EQ(scanned_light.groups.size(), 9u);
  EXPECT_EQ(scanned_light.folds, 9u);
  std::swap(table.theta_i, table.theta_o);
  std::swap(table.phi_i, table.phi_o);
  const RowGroups scanned_viewer = groups_of(table);
  EXPECT_FALSE(scanned_viewer.by_viewer);
  EXPECT_EQ(scanned_viewer.groups.size(), 9u);
  EXPECT_EQ(scanned_viewer.groups[0].theta, 15);
  EXPECT_EQ(scanned_viewer.groups[0].range.rows, 80u);
}

TEST(LeftOut, ManyDirectionsOfBothSidesShareCells) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> theta(0, 80), phi(0, 360);
  io::SampleTable table;
  for (int k = 0; k < 5000; ++k) table.add_directions(theta(random), phi(random), theta(random), phi(random));
  const DirectionArrays<double> arrays = io::unit_directions(table);
  const RowGroups groups = group_rows(arrays.view(), table.rows());
  EXPECT_LE(groups.groups.size(), 81u * 12u);
  EXPECT_GE(groups.groups.size(), 900u);
  EXPECT_EQ(groups.folds, kMostFolds);
  std::size_t rows = 0;
  for (const RowGroup& g : groups.groups) rows += g.range.rows;
  EXPECT_EQ(rows, 5000u);
}

// The results are bit-identical, because rows are sorted before anything is summed. The table has 11,000
// rows, more than the number on which the starting points are solved (8,192).
TEST(LeftOut, TheRankingIsTheSameForShuffledRows) {
  io::SampleTable table = measured(gloss(0.05), {"hemisphere"}, 0.03, 1, 2.5);
  ASSERT_GT(table.rows(), 8192u);
  const auto models = std::vector{forms({"lambert"}), forms({"ward"}), forms({"cook_torrance"})};
  const io::Json a = to_json(fit(table, models, {}), table, {}),
                 b = to_json(fit(shuffled(table), models, {}), table, {});
  EXPECT_EQ(a, b);
  EXPECT_EQ(a["ranking"][0]["form"], "cook_torrance");
  EXPECT_EQ(a["ranking"][0]["left_out_by_incidence"].size(), 5u);
}

TEST(LeftOut, RobustFitsAreJudgedByOneLoss) {
  FitOptions options;
  options.loss = Loss::huber;
  const io::SampleTable table = measured(gloss(0.15), {"hemisphere"}, 0.03);
  const FitResult result = fit(table, {forms({"lambert"}), forms({"cook_torrance"})}, options);
  EXPECT_EQ(result.ranking[0].form, "cook_torrance");
  EXPECT_GT(result.ranking[1].loss_scale, 1.2 * result.ranking[0].loss_scale);
  FitOptions same = options;
  same.loss_scale = result.ranking[0].loss_scale;
  const FitResult by_one = fit(table, {forms({"cook_torrance"})}, same);
  EXPECT_NEAR(by_one.ranking[0].left_out->value / result.ranking[0].left_out->value, 1, 1e-6);
}

std::vector<RowGroup> equal_groups(std::size_t n) {
  std::vector<RowGroup> groups(n);
  for (std::size_t g = 0; g < n; ++g) groups[g].range = {10 * g, 10};
  return groups;
}

TEST(PairedTest, AgreesWithTheTables) {
  // t = 3 / (sqrt(2.5) / sqrt(5)) = 4.2426 with 4 degrees of freedom. By ranks, 1 of 32 draws is as
  // extreme.
  const PairedTest five = paired_test(equal_groups(5), {1, 2, 3, 4, 5}, {0, 0, 0, 0, 0});
  EXPECT_NEAR(five.t, 0.0066178, 1e-6);
  EXPECT_NEAR(five.ranks, 1.0 / 32, 1e-12);
  // One positive against four negative differences: the ranks of the positive ones sum to 5 of 15, which 25
  // of 32 draws reach.
  EXPECT_NEAR(paired_test(equal_groups(5), {-1, -2, -3, -4, 5}, {0, 0, 0, 0, 0}).ranks, 25.0 / 32, 1e-12);
  // A single group that is far worse does not decide either test.
  EXPECT_FALSE(paired_test(equal_groups(6), {0, 0, 0, 0, 0, 9}, {0, 0, 0, 0, 0, 0}).worse());
  // Above 25 groups the normal approximation is used. Here all 30 groups differ in the same direction.
  std::vector<double> up(30), zero(30, 0);
  std::iota(up.begin(), up.end(), 1.0);
  EXPECT_LT(paired_test(equal_groups(30), up, zero).ranks, 2e-6);
  EXPECT_GT(paired_test(equal_groups(30), zero, up).ranks, 0.999);
}

FormFit with_values(const char* form, Verdict verdict, std::size_t parameters, std::vector<double> by_group) {
  FormFit f;
  f.form = form;
  f.verdict = verdict;
  f.parameters = parameters;
  f.minima.resize(1);
  f.left_out = LeftOut{};
  f.left_out->value = std::accumulate(by_group.begin(), by_group.end(), 0.0) / double(by_group.size());
  f.left_out->by_group = std::move(by_group);
  return f;
}

TEST(Ranking, TheRecommendedIsNotWorseThanTheBestIdentifiedOrNot) {
  FitResult result;
  result.groups.groups = equal_groups(6);
  result.ranking = {with_values("close", Verdict::converged, 2, {1.0, 2.1, 0.9, 2.0, 1.1, 2.0}),
                    with_values("worse", Verdict::converged, 1, {1.5, 2.5, 1.6, 2.4, 1.5, 2.6}),
                    with_values("best", Verdict::not_identifiable, 4, {1.1, 1.9, 1.0, 1.9, 1.0, 2.1})};
  rank(result);
  EXPECT_EQ(result.ranking[0].form, "best");
  EXPECT_EQ(result.ranking[result.recommended].form, "close");
  result.ranking.erase(result.ranking.begin() + 1);
  rank(result);
  EXPECT_EQ(result.ranking[result.recommended].form, "best");
}

TEST(Ranking, WithoutAFiniteValueAFormIsLast) {
  FitResult result;
  result.groups.groups = equal_groups(2);
  result.ranking = {
      with_values("infinite", Verdict::converged, 1, {1, std::numeric_limits<double>::infinity()}),
      with_values("misfit", Verdict::misfit, 1, {3, 4})};
  rank(result);
  EXPECT_EQ(result.ranking[0].form, "misfit");
}

}  // namespace
}  // namespace brdf::fit
