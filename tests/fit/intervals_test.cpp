// Tests how wide intervals must be if another parameter is at its bound, along valleys of the cost, and for
// few rows.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "fit/assess/derived.h"
#include "fit/assess/hidden_lobe.h"
#include "fit/assess/reported.h"
#include "fit/prepared.h"
#include "samples.h"

namespace brdf::fit {
namespace {

using testing::Contains;
using testing::HasSubstr;

Material material_of(const char* form, std::vector<double> shape, std::vector<double> weights) {
  Material m = make_material(*find_form(form), {"f"});
  m.terms[0].shape[0] = std::move(shape);
  m.terms[0].weights[0] = std::move(weights);
  return m;
}

// Returns the values of a material at these pairs (theta_i, theta_o, phi_o in degrees) with noise in
// proportion to the values. The light is at azimuth 180.
io::SampleTable at_pairs(const Material& material, const std::vector<std::array<double, 3>>& pairs,
                         double noise, std::uint64_t seed) {
  io::SampleTable table;
  table.channels = {"f"};
  table.values.resize(1);
  table.sigma.resize(1);
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  std::vector<double> value(1);
  for (const auto& [theta_i, theta_o, phi_o] : pairs) {
    table.add_directions(theta_i, 180, theta_o, phi_o);
    eval(material, direction(degrees(theta_i), 180_deg), direction(degrees(theta_o), degrees(phi_o)), value);
    table.values[0].push_back(value[0] * std::exp(noise * normal(random)));
  }
  return table;
}

// Returns pairs with light and viewer in the same direction.
std::vector<std::array<double, 3>> collocated() {
  std::vector<std::array<double, 3>> pairs;
  for (int k = 0; k < 50; ++k) pairs.push_back({1.4 * k, 1.4 * k, 180});
  return pairs;
}

// Returns pairs of which a single ring of half angles, 3 degrees, sees a narrow lobe.
std::vector<std::array<double, 3>> ring() {
  std::vector<std::array<double, 3>> pairs;
  for (const double theta_i : {0, 24})
    for (const double theta_o : {6, 18, 30, 42, 54, 66})
      for (const double phi_o : {0, 90, 270}) pairs.push_back({theta_i, theta_o, phi_o});
  return pairs;
}

TEST(Profiles, OfCollocatedSamplesKnowOnlyTheProductOfWeightAndReflectance) {
  const Material truth = material_of("cook_torrance", {0.25, 0.25}, {0.1, 0.8, 0.06});
  const FormFit f =
      fit_one(at_pairs(truth, collocated(), 0.02, 4), {"cook_torrance"}, without_cross_validation());
  EXPECT_EQ(f.verdict, Verdict::determined);
  for (const char* name : {"ks", "f0"}) EXPECT_EQ(estimate(f, name).status, Status::unidentified) << name;
  EXPECT_TRUE(estimate(f, "ks").high_open);
  EXPECT_LT(estimate(f, "ks").low, 0.06);
  EXPECT_THAT(f.findings, Contains(HasSubstr("ks f0 = 0.04")));
  // These samples have light and viewer in the same direction. For any other pair the albedo has no upper
  // bound.
  const std::vector<double> value{0};
  const auto albedo = intervals(f.material, knowledge_of(f), value, [](const Material& m) {
    return std::vector<double>{m.terms[0].weights[0][1]};
  });
  ASSERT_TRUE(albedo);
  EXPECT_TRUE(std::isinf(albedo->front().high));
}

TEST(Profiles, OfAParameterBesideABoundReachTheTruth) {
  const Material truth = material_of("cook_torrance", {0.15, 0.15}, {0, 0.85, 0.96});
  int held = 0, at_limit = 0;
  constexpr int kTables = 20;
  for (std::uint64_t seed = 1; seed <= kTables; ++seed) {
    synth::Instrument instrument;
    instrument.grid.parts = {"in_plane"};
    instrument.grid.theta_i = {12, 32, 52};
    instrument.grid.step = 3;
    instrument.noise = 0.03;
    instrument.seed = seed;
    const FormFit f =
        fit_one(synth::measure(truth, instrument), {"cook_torrance"}, without_cross_validation());
    const Estimate& ks = estimate(f, "ks");
    held += ks.low <= 0.85 && 0.85 <= ks.high;
    const Estimate& f0 = estimate(f, "f0");
    if (f0.status != Status::at_bound) continue;
    ++at_limit;
    EXPECT_TRUE(f0.high_open);
    EXPECT_LT(f0.low, 0.96);
  }
  EXPECT_GE(at_limit, 4);
  EXPECT_GE(held, 17);  // about half, if only the curvature of the parameters inside their bounds is used
}

TEST(Profiles, OfOneRingOfHalfAnglesAreOpenAndTheFormIsNotIdentified) {
  const Material truth = material_of("ward", {0.022, 0.022}, {0.1, 0.4});
  for (const std::uint64_t seed : {1, 2, 3, 4, 5, 6}) {
    const FormFit f = fit_one(at_pairs(truth, ring(), 0.015, seed), {"ward"}, without_cross_validation());
    EXPECT_EQ(f.verdict, Verdict::not_identifiable) << seed;
    const Estimate &ks = estimate(f, "ks"), &alpha = estimate(f, "alpha_x");
    EXPECT_TRUE(ks.status == Status::unidentified && (ks.low_open || ks.low < 0.4)) << seed;
    EXPECT_TRUE(alpha.low_open || alpha.low < 0.022) << seed << ": " << alpha.low;
    EXPECT_TRUE(alpha.high_open || alpha.high > 0.022) << seed;
  }
}

TEST(Profiles, OfAWellMeasuredGlossAreThoseOfTheCurvature) {
  const Material truth = material_of("ward", {0.2, 0.2}, {0.2, 0.3});
  const io::SampleTable table = measured(truth, {"hemisphere"}, 0.02, 3);
  const FormFit f = fit_one(table, {"ward"}, without_cross_validation());
  EXPECT_EQ(f.intervals, IntervalsBy::profile);
  for (const Estimate& e : f.estimates) {
    EXPECT_FALSE(e.low_open || e.high_open) << e.name;
    EXPECT_NEAR((e.high - e.low) / (2 * 1.97 * e.standard_error), 1, 0.1) << e.name;
  }
}

TEST(Profiles, OnlyTheFirstAndTheRecommendedFormHaveThem) {
  const Material truth = material_of("ward", {0.2, 0.2}, {0.2, 0.3});
  const FitResult result =
      fit(measured(truth, {"hemisphere"}, 0.02, 3), canonical_models(), without_cross_validation());
  std::size_t profiled = 0;
  for (const FormFit& f : result.ranking) profiled += f.intervals == IntervalsBy::profile;
  EXPECT_EQ(result.ranking[0].intervals, IntervalsBy::profile);
  EXPECT_LE(profiled, 2u);
}

TEST(Freedom, IsOfTheRowsOfAChannelWhateverTheirNumber) {
  const Material truth = make_material(*find_form("lambert"), std::vector<std::string>(24, "f"));
  io::SampleTable table;
  for (int c = 0; c < 24; ++c) table.channels.push_back("b" + std::to_string(c));
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  table.values.resize(24);
  table.sigma.resize(24);
  for (int k = 0; k < 24; ++k) {  // as many rows as parameters
    table.add_directions(3 * k, 180, 40, 0);
    for (auto& values : table.values) values.push_back(0.1 * std::exp(0.02 * normal(random)));
  }
  const FormFit f = fit_one(table, {"lambert"}, without_cross_validation());
  for (const Estimate& e : f.estimates) {
    EXPECT_EQ(e.freedom, 23);
    EXPECT_GT(e.high - e.low, 0.001);
    EXPECT_LT(e.high - e.low, 0.012);
  }
}

TEST(Bounds, AreNamedAsTheyWereAskedFor) {
  const Material truth = material_of("cook_torrance", {0.15, 0.15}, {0.1, 0.5, 0.9});
  FitOptions options = without_cross_validation();
  options.bounds = {{"f0", 0, 0.4}};
  const FormFit f = fit_one(measured(truth, {"hemisphere"}, 0.01), {"cook_torrance"}, options);
  EXPECT_THAT(f.findings, Contains(HasSubstr("f0 is at its upper bound 0.4")));
  EXPECT_TRUE(estimate(f, "f0").high_open);
}

TEST(FewRows, AreNamedWithTheParametersThatTheyDecide) {
  const Material truth = material_of("ward", {0.06, 0.06}, {0.2, 0.5});
  std::vector<std::array<double, 3>> pairs;
  for (int k = 0; k < 40; ++k) pairs.push_back({30, double(2 * k), 100});
  pairs.push_back({30, 30, 0});
  pairs.push_back({30, 35, 0});
  const FormFit f = fit_one(at_pairs(truth, pairs, 0.02, 5), {"ward"}, without_cross_validation());
  EXPECT_LT(estimate(f, "ks").deciding, 4);
  EXPECT_GT(estimate(f, "kd").deciding, 4);
  EXPECT_THAT(f.few_rows_decide, HasSubstr("42 of the table"));
  EXPECT_THAT(f.few_rows_decide, HasSubstr("ks"));
  // A hemisphere of rows around the lobe must not give this finding.
  const FormFit dense = fit_one(measured(material_of("ward", {0.3, 0.3}, {0.2, 0.5}), {"hemisphere"}, 0.02),
                                {"ward"}, without_cross_validation());
  EXPECT_EQ(dense.few_rows_decide, "");
}

TEST(HiddenHighlight, IsToldByTheDirections) {
  const auto width = [](const std::vector<std::array<double, 3>>& pairs) {
    const io::SampleTable table = at_pairs(material_of("lambert", {}, {0.4}), pairs, 0.02, 2);
    return hidden_width(prepare(table, {}), 0.02);
  };
  std::vector<std::array<double, 3>> mirror, beside;
  for (int k = -10; k <= 10; ++k) {
    mirror.push_back({30, 30.0 + k, 0});
    beside.push_back({30, 30.0 + 4 * k + 2, 0});
  }
  EXPECT_FALSE(width(mirror));  // a row in the mirror direction sees even the narrowest lobe
  ASSERT_TRUE(width(beside));   // rows 2 degrees from the mirror direction: half angles of 1 degree
  EXPECT_GT(*width(beside), 0.002);
  EXPECT_LT(*width(beside), 0.02);
}

TEST(HeldOut, AreWholeLightsFromTwoOn) {
  const auto groups = [](std::vector<double> lights, std::size_t viewers) {
    DirectionArrays<double> d(lights.size() * viewers);
    std::size_t row = 0;
    for (const double theta : lights)
      for (std::size_t k = 0; k < viewers; ++k)
        d.set(row++, direction(degrees(theta), 180_deg), direction(degrees(3.0 * double(k)), {}));
    return group_rows(d.view(), row);
  };
  EXPECT_EQ(groups({10, 40}, 20).groups.size(), 2u);
  EXPECT_EQ(groups({10, 40}, 20).held_out, HeldOut::few);
  EXPECT_EQ(groups({10, 20, 30, 40, 50}, 20).held_out, HeldOut::many);
  EXPECT_EQ(groups({10}, 20).held_out, HeldOut::interpolation);
}

// The folds must be the same on machines with any vector width, and for a table that is turned about its
// normal.
TEST(HeldOut, FoldsFollowFromTheDirectionsAlone) {
  const auto folds = [](double turn) {
    DirectionArrays<double> d(24);
    for (std::size_t k = 0; k < 24; ++k)
      d.set(k, direction(degrees(3.0 * double(k) + 1), degrees(turn + 10.0 * double(k % 5))),
            direction(20_deg, degrees(turn)));
    RowGroups g = group_rows(d.view(), 24);
    std::vector<std::size_t> out;
    for (const std::uint32_t group : g.group_of) out.push_back(g.groups[group].fold);
    return out;
  };
  EXPECT_EQ(folds(0), folds(37));
  EXPECT_EQ(folds(0), folds(211));
  EXPECT_EQ(folds(0), (std::vector<std::size_t>{6, 10, 8, 3, 4, 0, 5, 1, 4, 0, 8, 1,
                                                9, 6,  2, 0, 7, 9, 5, 7, 3, 1, 2, 10}));
}

}  // namespace
}  // namespace brdf::fit
