// Fits of matt surfaces by a basis with weights of either sign, and of retroreflectors.
#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "brdf/integrals.h"
#include "brdf/least_of_matt.h"
#include "samples.h"

namespace brdf::fit {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

Material of_weights(const char* form, std::vector<double> weights) {
  Material m = make_material(*find_form(form), {"f"});
  m.terms[0].weights = {std::move(weights)};
  return m;
}

io::SampleTable seen(const Material& material, std::vector<double> lights, double noise) {
  synth::Instrument instrument;
  instrument.grid.parts = {"hemisphere"};
  instrument.grid.step = 15;
  instrument.grid.theta_i = std::move(lights);
  instrument.noise = noise;
  instrument.seed = 3;
  return synth::measure(material, instrument);
}

const std::vector<double> kTile{0.9, 0.07, 0.13, -0.18, 0.1, 0.06, 0.14, -0.09};

TEST(MattFit, TheWeightsOfAKnownSurfaceAreFound) {
  const FormFit f = fit_one(seen(of_weights("matt_8", kTile), {5, 20, 35, 50, 65, 75}, 0.004), {"matt_8"});
  EXPECT_TRUE(usable(f.verdict));
  const auto table = info(*find_form("matt_8")).weights;
  for (std::size_t k = 0; k < kTile.size(); ++k) {
    const Estimate& e = estimate(f, table[k].name);
    EXPECT_NEAR(e.value, kTile[k], 4 * e.standard_error + 1e-9) << table[k].name;
    EXPECT_LT(e.standard_error, 0.02) << table[k].name;
  }
  EXPECT_THAT(f.findings, Not(Contains(HasSubstr("bounded"))));
}

// A dark surface of which only f >= 0 is seen: the rows end where the polynomial would fall below 0.
io::SampleTable dark() {
  const Material m = of_weights("matt_5", {0.31, -0.44, 0.285, -0.14, 0.25});
  synth::Instrument instrument;
  instrument.grid.parts = {"hemisphere"};
  instrument.grid.step = 15;
  instrument.grid.theta_i = {0, 15, 30, 45};
  io::SampleTable table = synth::measure(of_weights("lambert", {0.5}), instrument);
  const DirectionArrays<double> arrays = io::unit_directions(table);
  for (std::size_t k = 0; k < table.rows(); ++k) {
    double f = 0;
    eval(m, arrays.view().wi(k), arrays.view().wo(k), {&f, 1});
    // One per cent of noise, the same at every run.
    table.values[0][k] = std::max(f, 1e-3) * (1 + 0.01 * std::sin(37.0 * double(k)));
  }
  return table;
}

TEST(MattFit, WeightsThatWouldGiveANegativeValueAreBoundedAndTheLossIsSaid) {
  FitOptions options;
  options.max_theta = 60;
  const FormFit f = fit_one(dark(), {"matt_5"}, options);
  ASSERT_TRUE(f.solved());
  EXPECT_THAT(f.findings, Contains(HasSubstr("so that f is not below 0 (without a bound f reaches -0.0")));
  const MattBasis& basis = *info(*find_form("matt_5")).basis;
  EXPECT_GE(least_of_matt(basis, f.material.terms[0].weights[0], 0).bound, 0);
  EXPECT_LT(f.median_relative_error, 0.03);
}

TEST(MattFit, AMaterialThatCanBeNegativeIsNeverUsable) {
  FitOptions options;
  options.fix = {{"w000", {0.3}}, {"w020", {-0.4}}, {"w220", {0.3}}, {"w111", {-0.5}}};
  const FormFit f = fit_one(seen(of_weights("lambert", {0.3}), {10, 30, 50}, 0.01), {"matt_5"}, options);
  EXPECT_FALSE(usable(f.verdict));
  EXPECT_THAT(f.findings, Contains(HasSubstr("f of matt_5 reaches -")));
}

TEST(MattFit, PhysicalBoundsTheAlbedoOfTheBasis) {
  const io::SampleTable bright = seen(of_weights("matt_5", {1.03, 0.05, 0.1, -0.2, 0.1}), {5, 20, 40, 60}, 0);
  FitOptions options;
  options.physical = Physical::either;
  const FormFit f = fit_one(bright, {"matt_5"}, options);
  EXPECT_THAT(f.findings, Contains(HasSubstr("the albedo is not above 1")));
  for (const double theta : {0.0, 45.0, 90.0})
    EXPECT_LE(directional_albedo(f.material.terms[0], 0, degrees(theta), {}, {.tolerance = 1e-9}).value, 1);
  EXPECT_GT(directional_albedo(f.material.terms[0], 0, 0_deg, {}, {.tolerance = 1e-9}).value, 0.97);
}

TEST(MattFit, TheBasisIsTheBodyOfASum) {
  Material m = of_weights("matt_5", {0.5, 0.05, 0.08, -0.1, 0.06});
  Material lobe = make_material(*find_form("cook_torrance"), {"f"});
  lobe.terms[0].shape = {{0.15, 0.15}};
  lobe.terms[0].weights = {{0, 0.8, 0.04}};
  m.terms.push_back(lobe.terms[0]);
  FitOptions options;
  options.fix = {{"f0", {0.04}}};
  const FormFit f = fit_one(fine_hemisphere(m, 0.005, 4), {"matt_5", "cook_torrance"}, options);
  EXPECT_TRUE(usable(f.verdict));
  EXPECT_EQ(estimate(f, "terms[1].kd").status, Status::fixed);
  EXPECT_NEAR(estimate(f, "terms[1].alpha_x").value, 0.15, 0.005);
  EXPECT_NEAR(estimate(f, "terms[0].w111").value, -0.1, 0.02);
}

Material tape() {
  Material m = make_material(*find_form("cook_torrance"), {"f"});
  m.terms[0].shape = {{0.2, 0.2}};
  m.terms[0].weights = {{0.2, 0.7, 0.04}};
  Material back = make_material(*find_form("retro"), {"f"});
  back.terms[0].shape = {{0.07, 0.07}};
  back.terms[0].weights = {{0.5}};
  m.terms.push_back(back.terms[0]);
  return m;
}

TEST(RetroFit, ALobeAboutTheLightIsFoundInASum) {
  const FormFit f = fit_one(fine_hemisphere(tape(), 0.02, 6), {"cook_torrance", "retro"});
  EXPECT_NEAR(estimate(f, "terms[1].kr").value, 0.5, 0.02);
  EXPECT_NEAR(estimate(f, "terms[1].alpha_x").value, 0.07, 0.002);
  EXPECT_NEAR(estimate(f, "terms[0].alpha_x").value, 0.2, 0.01);
  EXPECT_TRUE(usable(f.verdict));
}

TEST(RetroFit, AutoKeepsTheLobeWhereTheSurfaceHasOne) {
  const FitResult result = fit(fine_hemisphere(tape(), 0.02, 6), {}, {});
  EXPECT_THAT(result.ranking.front().form, HasSubstr("retro"));
}

TEST(MattFit, AutoChoosesABasisForAMattSurfaceAndNoneForALambertianOne) {
  const std::vector<double> lights{5, 20, 35, 50, 65, 75};
  const FitResult matt = fit(seen(of_weights("matt_8", kTile), lights, 0.005), {}, {});
  EXPECT_THAT(matt.ranking.front().form, HasSubstr("matt_"));
  const FitResult white = fit(seen(of_weights("lambert", {0.8}), lights, 0.01), {}, {});
  EXPECT_EQ(white.ranking.front().form, "lambert");
  for (const FormFit& f : white.ranking) EXPECT_THAT(f.form, Not(HasSubstr("matt_")));
}

TEST(MattFit, FourLightsAllowNoMoreThanFiveWeights) {
  const FitResult result = fit(seen(of_weights("matt_8", kTile), {5, 25, 45, 65}, 0.005), {}, {});
  for (const FormFit& f : result.ranking)
    for (const char* longer : {"matt_8", "matt_14", "matt_20"}) EXPECT_THAT(f.form, Not(HasSubstr(longer)));
}

}  // namespace
}  // namespace brdf::fit
