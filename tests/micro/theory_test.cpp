// Traced surfaces against theory: exact for mirror grooves and Lambertian grooves, approximate for Smith's
// masking; and the tables of traced samples.
#include "micro/theory.h"

#include <gtest/gtest.h>

#include <cmath>

#include "io/files/error.h"
#include "micro/cavity.h"
#include "micro/masking.h"
#include "micro/model.h"
#include "micro/samples.h"

namespace brdf::micro {
namespace {

// V-cavities are exact for mirror grooves: every cell that receives power agrees with the form's G and
// Fresnel factor.
TEST(Theory, MirrorGroovesAreTheVCavityForm) {
  Simulation s;
  s.geometry = Grooves{GrooveAngles::beckmann, 0.4, 1024};
  s.facets.eta = 1.5;
  s.surfaces = 128;
  s.rays = 4096;
  s.max_bounces = 1;
  const Cells cells(15_deg);
  const Incidence from{60_deg, {}};
  const Scatter scatter = measure_scatter(s, {from}, cells)[0];
  const Material form = model(form_of_mirror_grooves(), {{Role::diffuse, 0},
                                                         {Role::specular, 1},
                                                         {Role::width, 0.4},
                                                         {Role::width_across, 0.4},
                                                         {Role::index, 1.5}});
  int judged = 0;
  double error = 0, power = 0;
  for (int c = 0; c < cells.size(); ++c) {
    const double m = cell_mean(form, from, cells[c]);
    const double share = m * cells[c].projected_solid_angle();
    if (share < 1e-3) continue;
    ++judged;
    EXPECT_LT(std::abs(scatter.f[0][c].mean - m), 4.5 * scatter.f[0][c].standard_error) << c;
    error += scatter.f[0][c].standard_error / m * share;
    power += share;
  }
  EXPECT_GT(judged, 15);
  EXPECT_LT(error / power, 0.05);
}

TEST(Theory, LambertianGroovesAreTheCavityIntegral) {
  Simulation s;
  s.geometry = Grooves{GrooveAngles::oren_nayar, (30_deg).radians(), 1024};
  s.facets = {.reflection = Reflection::lambert, .rho = 1};
  s.surfaces = 16;
  s.rays = 4096;
  s.max_bounces = 1;
  const Incidence from{70_deg, {}};
  const std::vector<Incidence> views{{}, {70_deg, {}}, {50_deg, radians(2)}, {70_deg, radians(kPi)}};
  const auto f = measure_radiance(s, {from}, views)[0];
  for (std::size_t v = 0; v < views.size(); ++v) {
    const double exact = groove_single_reflection((30_deg).radians(), direction(from.theta, from.phi),
                                                  direction(views[v].theta, views[v].phi));
    EXPECT_LT(f[v].total.standard_error, 0.03 * exact);
    EXPECT_LT(std::abs(f[v].total.mean - exact), 4.5 * f[v].total.standard_error) << v;
  }
}

// Smith's masking is an approximation: on a correlated surface, facets tilted away from the viewer are less
// visible than Smith's G1 predicts.
TEST(Theory, SmithsMaskingIgnoresTheSlope) {
  Simulation s;
  s.geometry = HeightField{.alpha_x = 0.5, .alpha_y = 0.5, .size = 256};
  s.rays = 16384;
  const Angle theta = 75_deg;
  const double g1 = 1 / (1 + smith_lambda(0.5, theta));
  const Masking m = measure_masking(s, {theta})[0];
  EXPECT_LT(m.visible_away.mean, 0.9 * g1);
  EXPECT_GT(m.visible_away.mean, 0.75 * g1);
  EXPECT_GT(m.visible_towards.mean, 0.98 * g1);
  EXPECT_LT(m.visible_points.mean, 0.98 * g1);
  EXPECT_GT(m.visible_points.mean, 0.9 * g1);
}

TEST(Theory, FormsAreFoundByWhatTheyStandFor) {
  EXPECT_EQ(form_of_rough_mirrors().info().name, "cook_torrance_beckmann");
  EXPECT_EQ(form_of_mirror_grooves().info().name, "cook_torrance_vcavity");
  EXPECT_EQ(form_of_lambert_grooves().info().name, "oren_nayar");
  EXPECT_EQ(form_with_interreflection().info().name, "oren_nayar_full");
}

TEST(Theory, RowsWithoutErrorHaveNoZ) {
  EXPECT_TRUE(std::isnan(theory_row("a", "b", {1, kNone}, 2, true).z));
  EXPECT_TRUE(std::isnan(theory_row("a", "b", {1, 0}, 1, true).z));
  EXPECT_DOUBLE_EQ(theory_row("a", "b", {1, 0.5}, 2, true).z, -2);
  EXPECT_TRUE(holds(theory_row("a", "b", {1, 0.5}, 2, true)));
  EXPECT_FALSE(holds(theory_row("a", "b", {1, 0.1}, 2, true)));
  EXPECT_TRUE(holds(theory_row("a", "b", {1, 0.1}, 2, false)));
  EXPECT_FALSE(holds(theory_row("a", "b", {1e-4, kNone}, 0, true)));
  EXPECT_TRUE(holds(theory_row("a", "b", {1e-6, kNone}, 0, true)));
}

SampleSettings small(std::string surface) {
  SampleSettings s;
  s.surface = std::move(surface);
  s.theta_i = {0, 50};
  s.surfaces = 8;
  s.rays = 1000;
  s.cell = 15;
  s.size = 64;
  return s;
}

TEST(Samples, AreATableOfDirectionsInDegrees) {
  for (const std::string& name : surface_names()) {
    SampleSettings settings = small(name);
    settings.azimuths = {0, 90};
    settings.rays = 300;
    const io::SampleTable table = trace_samples(settings);
    ASSERT_GT(table.rows(), 20u) << name;
    EXPECT_EQ(table.channels, std::vector<std::string>{"fr"});
    EXPECT_TRUE(table.has_sigma(0));
    EXPECT_EQ(table.find_metadata("seed"), "1");
    EXPECT_TRUE(table.find_metadata("truth"));
    for (std::size_t k = 0; k < table.rows(); ++k) {
      EXPECT_TRUE(table.phi_i[k] == 180 || table.phi_i[k] == 90) << table.phi_i[k];
      EXPECT_GE(table.phi_o[k], 0);
      EXPECT_LT(table.phi_o[k], 360);
      EXPECT_GT(table.values[0][k], 0);
    }
    settings.threads = 1;
    EXPECT_EQ(trace_samples(settings).values, table.values);
  }
}

TEST(Samples, MirrorsOfATurnedSampleAreThoseOfTurnedLight) {
  SampleSettings settings = small("gaussian");
  settings.parameters = {{"alpha_x", 0.1}, {"alpha_y", 0.5}};
  settings.theta_i = {0};
  settings.azimuths = {90};
  // alpha_y is larger than alpha_x, so the lobe is wide along y for every azimuth of incidence.
  double along_x = 0, along_y = 0;
  const io::SampleTable table = trace_samples(settings);
  for (std::size_t k = 0; k < table.rows(); ++k) {
    const double phi = degrees(table.phi_o[k]).radians(),
                 spread = std::sin(degrees(table.theta_o[k]).radians()) * table.values[0][k];
    along_x += spread * square(std::cos(phi));
    along_y += spread * square(std::sin(phi));
  }
  EXPECT_GT(along_y, 2 * along_x);
}

TEST(Samples, OrdersAddUp) {
  SampleSettings settings = small("gaussian");
  settings.parameters = {{"alpha", 0.8}};
  const io::SampleTable all = trace_samples(settings);
  settings.orders = true;
  const io::SampleTable apart = trace_samples(settings);
  ASSERT_EQ(apart.channels.size(), 3u);
  double second = 0;
  for (std::size_t k = 0; k < all.rows(); ++k) {
    EXPECT_NEAR(apart.values[0][k] + apart.values[1][k] + apart.values[2][k], all.values[0][k], 1e-12);
    second += apart.values[1][k];
  }
  EXPECT_GT(second, 0);
}

TEST(Samples, RefuseWhatIsOutOfRange) {
  const auto refused = [](SampleSettings s) { EXPECT_THROW(trace_samples(s), InputError); };
  refused(small("gausian"));
  SampleSettings s = small("gaussian");
  s.parameters = {{"sigma", 0.3}};
  refused(s);
  s.parameters = {{"alpha", 20}};
  refused(s);
  s = small("lambert_grooves");
  s.theta_i = {95};
  refused(s);
  s = small("gaussian");
  s.surfaces = 2;
  refused(s);
}

// A part of the comparisons; tests/micro/slow runs all.
TEST(Theory, ExactRowsHoldAndEveryApproximationHasItsCause) {
  std::vector<TheoryRow> rows = compare_slopes({});
  for (TheoryRow& row : compare_masking({})) rows.push_back(std::move(row));
  for (TheoryRow& row : compare_mirror_grooves({}, 30_deg)) rows.push_back(std::move(row));
  int exact = 0, approximations = 0;
  for (const TheoryRow& row : rows) {
    const bool is_approximation = !row.exact && !std::isnan(row.model);
    EXPECT_TRUE(holds(row)) << row.surface << ' ' << row.quantity << ' ' << row.z;
    EXPECT_EQ(!row.cause.empty(), is_approximation) << row.quantity;
    exact += row.exact;
    approximations += is_approximation;
  }
  EXPECT_NEAR(exact, 46, 4);  // 14 of them cells of the grooves, by their power
  EXPECT_EQ(approximations, 24);
}

}  // namespace
}  // namespace brdf::micro
