// Tests each check on either side of its limit. A check must fail if the fault is visible, and must neither
// fail nor pass if the table cannot show the fault.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

#include "brdf/angle.h"
#include "tables.h"

namespace brdf::sheet {
namespace {

using testing::HasSubstr;
using testing::Not;

double cosine(double theta) {
  return std::cos(degrees(theta).radians());
}

io::SampleTable scaled_light(const io::SampleTable& t, double light, double factor) {
  return changed(t, [&](std::size_t k, double v) { return t.theta_i[k] == light ? factor * v : v; });
}

TEST(Power, CleanTablesOfEveryGridHaveNoFailingCheck) {
  for (const Grid& grid :
       {Grid{}, Grid::in_plane(), Grid::half_plane(), Grid{.lights = {20, 40, 60}, .step = 10}})
    for (const Material& material : {glossy(), matt(0.8), glossy(0.02, 0.9, 0.9, 0.1)})
      for (const double noise : {0.0, 0.01, 0.05})
        EXPECT_EQ(failing(measured(material, grid, noise)), Names{});
}

TEST(Power, ABrfOfABrightSampleFailsOverTheHemisphereAndIsSuspectedInThePlane) {
  const auto times_pi = [](std::size_t, double v) { return kPi * v; };
  const Finding hemisphere = finding(changed(measured(matt(0.8)), times_pi), "quantity");
  EXPECT_EQ(hemisphere.outcome, Outcome::fail);
  EXPECT_THAT(hemisphere.statement, HasSubstr("BRF"));
  const DataSheet plane = data_sheet(changed(measured(glossy(0.8, 0.4), Grid::in_plane()), times_pi));
  EXPECT_EQ(finding(plane, "quantity").outcome, Outcome::undecided);
  EXPECT_TRUE(finding(plane, "quantity").is_suspicion);
  EXPECT_THAT(finding(plane, "quantity").statement, HasSubstr("BRF"));
  ASSERT_FALSE(plane.faults().empty());
  EXPECT_EQ(plane.faults().front()->check, "quantity");
  // For f_r itself in the plane of incidence, no scale is proved and no other scale is suspected.
  const Finding clean = finding(measured(glossy(0.8, 0.4), Grid::in_plane()), "quantity");
  EXPECT_EQ(clean.outcome, Outcome::undecided);
  EXPECT_FALSE(clean.is_suspicion) << clean.statement;
}

TEST(Power, APlaneOfBlacknessIsNoMeasurementOfFr) {
  io::SampleTable t = measured(matt(0.5), Grid::in_plane());
  for (double& v : t.values[0]) v = 2.1e-5;
  EXPECT_EQ(finding(t, "quantity").outcome, Outcome::fail);
  for (double& v : t.values[0]) v = 8e-5;  // 2.5e-4 of the light: the blackest coatings
  EXPECT_NE(finding(t, "quantity").outcome, Outcome::fail);
}

// "At least" is a lower bound. It must not exceed the true albedo for any lobe, grid or offset of the grid.
TEST(Power, TheLowerBoundOfTheAlbedoIsNeverAboveTheTruth) {
  for (const double alpha : {0.003, 0.01, 0.03, 0.1, 0.3, 1.0}) {
    const Material metal = glossy(0, 1, 0.9, alpha);
    for (const double step : {1.0, 2.5, 5.0, 10.0})
      for (const Grid& grid : {Grid::in_plane(step), Grid::half_plane(step),
                               Grid{.step = step, .azimuths = Grid::every(10, 180)},
                               Grid{.step = step, .azimuths = Grid::every(5, 355)}})
        for (const MeasuredAlbedo& a : data_sheet(measured(metal, grid, 0)).albedo)
          EXPECT_LE(a.least[0], 0.95)
              << alpha << ' ' << step << ' ' << a.theta_i;  // the albedo of the metal is 0.90 to 0.94
  }
  // The bound is informative: it contains nearly all of the light that a matt surface reflects below the
  // last ring.
  for (const MeasuredAlbedo& a : data_sheet(measured(matt(0.8), {}, 0.001)).albedo) {
    EXPECT_LE(a.least[0], 0.8);
    EXPECT_GE(a.least[0], 0.65);
  }
}

TEST(Power, AFewViewersUnderManyLightsProveNoScale) {
  // A valid metal, with the light scanned past fixed viewers.
  Grid grid{.lights = {}, .step = 10, .last = 80, .azimuths = {0}};
  for (double light = 2; light < 86; light += 3) grid.lights.push_back(light);
  for (const double alpha : {0.005, 0.012, 0.03, 0.1}) {
    const io::SampleTable t = measured(glossy(0, 1, 0.9, alpha), grid);
    EXPECT_EQ(failing(t), Names{}) << alpha;
    EXPECT_FALSE(finding(t, "quantity").is_suspicion) << alpha << finding(t, "quantity").statement;
  }
}

TEST(Power, AnisotropyIsToldByRatiosWhichNeverSaturate) {
  const auto turned = [](double factor) {
    io::SampleTable t = measured(matt(0.5), {.lights = {20, 50}, .step = 20});
    const std::size_t rows = t.rows();
    for (std::size_t k = 0; k < rows; ++k) {
      t.add_directions(t.theta_i[k], t.phi_i[k] + 90, t.theta_o[k], t.phi_o[k] + 90);
      t.values[0].push_back(t.values[0][k] * factor);
      t.lines.push_back(std::uint32_t(t.lines.size() + 2));
    }
    return finding(t, "isotropy");
  };
  for (const double factor : {1.5, 4.0, 20.0, 400.0}) {
    EXPECT_EQ(turned(factor).outcome, Outcome::undecided) << factor;
    EXPECT_THAT(turned(factor).statement, HasSubstr("the sample is anisotropic"));
    EXPECT_NEAR(turned(factor).value, std::log(factor), 0.1);
  }
  EXPECT_THAT(turned(1).statement, Not(HasSubstr("anisotropic")));
}

TEST(Power, AZeroErrorOfTwoDegreesIsFoundUnderHighlightsOnly) {
  const auto shifted = [](io::SampleTable t) {
    for (double& theta : t.theta_o) theta += 2;
    return t;
  };
  for (const Grid& grid : {Grid{}, Grid::in_plane()}) {
    const Finding f = finding(shifted(measured(glossy(0.05, 0.9, 0.06, 0.08), grid)), "mirror");
    EXPECT_EQ(f.outcome, Outcome::fail) << f.statement;
    EXPECT_THAT(f.statement, HasSubstr("a zero error of theta_o or of theta_i"));
    EXPECT_NEAR(f.value, 2, 0.5);
    EXPECT_EQ(finding(measured(glossy(), grid), "mirror").outcome, Outcome::pass);
  }
  // Without a highlight nothing can be concluded about the mirror direction.
  EXPECT_EQ(finding(shifted(measured(matt(0.7))), "mirror").outcome, Outcome::not_applicable);
  // With few lights and a coarse grid the zero error remains undecided.
  const Finding coarse =
      finding(measured(glossy(0.2, 0.6, 0.05, 0.35), {.lights = {45, 50, 55}, .step = 10}, 0.05), "mirror");
  EXPECT_NE(coarse.outcome, Outcome::pass) << coarse.statement;
  EXPECT_NE(coarse.outcome, Outcome::fail) << coarse.statement;
}

TEST(Power, OneWrongLabelIsNamedWithTheLightThatItBelongsTo) {
  io::SampleTable t = measured(glossy());
  for (double& theta : t.theta_i)
    if (theta == 40) theta = 48;
  const Finding f = finding(t, "mirror");
  EXPECT_EQ(f.outcome, Outcome::fail);
  EXPECT_THAT(f.statement, HasSubstr("the highlight at incidence 48 degrees is at the position"));
  EXPECT_NEAR(f.value, -8, 2);
  // The wrong label is that of another light: two scans have the same angle.
  t = measured(glossy());
  for (double& theta : t.theta_i)
    if (theta == 40) theta = 50;
  EXPECT_THAT(finding(t, "mirror").statement, HasSubstr("its label seems wrong"));
}

TEST(Power, OneLightsGainIsFoundWithItsSizeAndNotTakenForACosine) {
  const io::SampleTable t = measured(glossy(), {}, 0.03);
  const DataSheet sheet = data_sheet(scaled_light(t, 40, 1.2));
  const Finding f = finding(sheet, "light_gain");
  EXPECT_EQ(f.outcome, Outcome::fail) << f.statement;
  EXPECT_NEAR(std::exp(f.value), 1.2, 0.02);
  EXPECT_THAT(f.statement, HasSubstr("values at incidence 40 degrees"));
  EXPECT_NE(finding(sheet, "cosine_factor").outcome, Outcome::fail);
  EXPECT_EQ(finding(t, "light_gain").outcome, Outcome::pass);
  // The steepest light is three times too bright. A cosine explains this less well than a gain does.
  const DataSheet steep = data_sheet(scaled_light(
      measured(glossy(0.3, 0.4, 0.05, 0.4), {.lights = {10, 30, 50, 70}, .step = 10}, 0.03), 70, 3));
  EXPECT_EQ(finding(steep, "light_gain").outcome, Outcome::fail);
  EXPECT_NE(finding(steep, "cosine_factor").outcome, Outcome::fail);
  // With two lights it cannot be decided which of them is wrong.
  EXPECT_EQ(finding(scaled_light(measured(glossy(), {.lights = {20, 60}}), 20, 1.5), "light_gain").outcome,
            Outcome::not_applicable);
}

TEST(Power, ADriftThroughTheFileIsFound) {
  const io::SampleTable t = measured(matt(0.6), {}, 0.02);
  const double last = double(t.rows() - 1);
  const Finding f = finding(
      changed(t, [&](std::size_t k, double v) { return v * (1 - 0.25 * double(k) / last); }), "drift");
  EXPECT_EQ(f.outcome, Outcome::fail) << f.statement;
  EXPECT_NEAR(std::exp(f.value), 0.75, 0.05);
  EXPECT_EQ(finding(t, "drift").outcome, Outcome::pass);
}

TEST(Power, ADarkLevelIsFoundWhereItBreaksReciprocity) {
  const io::SampleTable t = measured(glossy(0.05, 0.6), {}, 0.002);
  const double level = 0.01;
  const Finding f = finding(
      changed(t, [&](std::size_t k, double v) { return v + level / cosine(t.theta_o[k]); }), "dark_level");
  EXPECT_TRUE(f.outcome == Outcome::fail || f.is_suspicion) << f.statement;
  EXPECT_GT(f.value, 0.1);
  EXPECT_EQ(finding(t, "dark_level").outcome, Outcome::pass);
}

TEST(Power, ACosineIsClaimedWhereTheExponentIsTight) {
  const io::SampleTable t = measured(glossy(0.3, 0.4, 0.05, 0.4), {}, 0.02);
  for (const auto& [name, of] : {std::pair{"cos_i", &t.theta_i}, std::pair{"cos_o", &t.theta_o}}) {
    const Finding f =
        finding(changed(t, [&, column = of](std::size_t k, double v) { return v * cosine((*column)[k]); }),
                "cosine_factor");
    EXPECT_EQ(f.outcome, Outcome::fail);
    EXPECT_THAT(f.statement, HasSubstr(std::string("f_r times ") + name));
  }
  // The square root of a cosine must not be reported as a cosine.
  const Finding half =
      finding(changed(t, [&](std::size_t k, double v) { return v * std::sqrt(cosine(t.theta_i[k])); }),
              "cosine_factor");
  EXPECT_EQ(half.outcome, Outcome::undecided) << half.statement;
  EXPECT_THAT(half.statement, HasSubstr("not a whole cosine"));
}

TEST(Power, ZerosOfADetectorThatSawNothingAreNoMeasurements) {
  const io::SampleTable t = measured(matt(0.8), Grid::in_plane(3));
  const auto blind = [&](std::size_t k, double v) {
    return t.phi_o[k] == 180 && std::abs(t.theta_o[k] - t.theta_i[k]) < 8 ? 0 : v;
  };
  const DataSheet sheet = data_sheet(changed(t, blind));
  const Finding f = finding(sheet, "fill");
  EXPECT_EQ(f.outcome, Outcome::fail);
  EXPECT_EQ(f.value, double(std::count(sheet.not_measured.begin(), sheet.not_measured.end(), true)));
  EXPECT_EQ(f.rows.size(), std::size_t(f.value));
  for (std::size_t k = 0; k < t.rows(); ++k) EXPECT_EQ(sheet.not_measured[k], blind(k, 1) == 0) << k;
  EXPECT_TRUE(data_sheet(changed(t, blind), {.keep_fill = true}).not_measured.empty());
  EXPECT_TRUE(data_sheet(t).not_measured.empty());
}

TEST(Power, AnyNumberStandsForWhatWasNotMeasured) {
  const io::SampleTable t = measured(glossy());
  for (const double value : {0.0, -1.0, 999.0, 1e-9}) {
    const io::SampleTable filled =
        changed(t, [&](std::size_t k, double v) { return k % 17 == 3 ? value : v; });
    EXPECT_EQ(finding(filled, "fill").outcome, Outcome::fail) << value;
    EXPECT_EQ(failing(filled), Names{"fill"}) << value << finding(filled, "outliers").statement;
  }
}

TEST(Power, ZerosAmongNoiseOfTheirSizeAreData) {
  // A highlight above a dark level that a detector cannot distinguish from 0, cut off at 0.
  std::mt19937 random(4);
  std::normal_distribution<double> normal;
  const io::SampleTable t = measured(glossy(0, 0.5, 0.05, 0.08), {}, 0);
  const io::SampleTable clipped =
      changed(t, [&](std::size_t, double v) { return std::max(v + 5e-4 + 6e-4 * normal(random), 0.0); });
  EXPECT_GT(std::count(clipped.values[0].begin(), clipped.values[0].end(), 0.0), 100);
  EXPECT_EQ(finding(clipped, "fill").outcome, Outcome::pass);
  // The last digit is larger than the small values, so that they are rounded to 0.
  const io::SampleTable rounded =
      changed(t, [](std::size_t, double v) { return std::round(v * 1e3) * 1e-3; });
  EXPECT_EQ(finding(rounded, "fill").outcome, Outcome::pass);
}

TEST(Power, AReadingThatStandsStillIsStuckUnlessTheCurveIsFlat) {
  const io::SampleTable t = measured(glossy());
  const auto stuck = [&](std::size_t k, double v) { return k >= 300 && k < 308 ? t.values[0][300] : v; };
  const Finding f = finding(changed(t, stuck), "stuck");
  EXPECT_EQ(f.outcome, Outcome::fail);
  EXPECT_THAT(f.statement, HasSubstr("8 rows in succession"));
  // On a flat curve, few digits repeat a value as well.
  const io::SampleTable flat =
      changed(measured(matt(0.3)), [](std::size_t, double v) { return std::round(v * 1e3) * 1e-3; });
  EXPECT_EQ(finding(flat, "stuck").outcome, Outcome::pass);
  EXPECT_EQ(finding(measured(matt(0.3), {}, 0), "stuck").outcome, Outcome::undecided);
}

TEST(Power, RowsThatSoftwareMadeAreNamed) {
  const io::SampleTable t = measured(glossy(0.5, 0.4, 0.05, 0.3), Grid::in_plane(1), 0.004);
  // The last values of every curve are on a straight line to 0 at 90 degrees.
  const Finding ramp = finding(
      changed(t,
              [&](std::size_t k, double v) {
                return t.theta_o[k] > 70 ? 0.2 * (90 - t.theta_o[k]) / 20 * (1 + 0.01 * t.theta_i[k]) : v;
              }),
      "invented");
  EXPECT_EQ(ramp.outcome, Outcome::fail);
  EXPECT_THAT(ramp.statement, HasSubstr("in a straight line to 0 at 90 degrees"));
  // Every other row is the mean of its neighbours.
  io::SampleTable filled = t;
  for (std::size_t k = 2; k + 2 < t.rows(); ++k)
    for (std::size_t n = k + 1; n < std::min(k + 3, t.rows()); ++n)
      if (std::lround(t.theta_o[k]) % 2 && t.theta_o[n] == t.theta_o[k] + 1 && t.phi_o[n] == t.phi_o[k] &&
          t.theta_o[k - 2] == t.theta_o[k] - 1)
        filled.values[0][k] = 0.5 * (t.values[0][k - 2] + t.values[0][n]);
  EXPECT_THAT(finding(filled, "invented").statement, HasSubstr("interpolated"));
  // The curve of one light appears under the angle of another light.
  io::SampleTable copied = t;
  for (std::size_t k = 0; k < t.rows(); ++k)
    for (std::size_t n = 0; n < t.rows(); ++n)
      if (t.theta_i[k] == 50 && t.theta_i[n] == 40 && t.theta_o[n] == t.theta_o[k] &&
          t.phi_o[n] == t.phi_o[k])
        copied.values[0][k] = t.values[0][n];
  EXPECT_THAT(finding(copied, "invented").statement, HasSubstr("40 and 50 degrees are identical"));
  // f_r times a cosine falls to 0 at 90 degrees as well, but is not a straight line.
  EXPECT_EQ(finding(changed(t, [&](std::size_t k, double v) { return v * cosine(t.theta_o[k]); }), "invented")
                .outcome,
            Outcome::pass);
  EXPECT_EQ(finding(t, "invented").outcome, Outcome::pass);
}

TEST(Power, SmoothErrorsCountAsScatter) {
  const io::SampleTable t = measured(glossy(0.3, 0.4, 0.05, 0.4), Grid::in_plane(), 0.002);
  const io::SampleTable wavy = changed(t, [&](std::size_t k, double v) {
    return v * std::exp(0.05 * std::sin(t.theta_o[k] / 5 + t.theta_i[k] + t.phi_o[k]));
  });
  const DataSheet sheet = data_sheet(wavy);
  EXPECT_LT(sheet.scatter.neighbours.value.value_or(1), 0.006);
  EXPECT_GT(finding(sheet, "noise_floor").value, 0.02);
  EXPECT_LT(finding(sheet, "noise_floor").value, 0.07);
  EXPECT_THAT(finding(sheet, "noise_floor").statement,
              HasSubstr("neighbours agree better than this noise permits"));
  EXPECT_THAT(finding(t, "noise_floor").statement, Not(HasSubstr("neighbours agree better")));
}

TEST(Power, RowsBeyondTheLargestAngleAreSetApartInEveryCheck) {
  io::SampleTable t = measured(matt(0.5), {.last = 90});
  for (std::size_t k = 0; k < t.rows(); ++k)
    if (t.theta_o[k] > 89.5) t.values[0][k] = -0.4;
  EXPECT_EQ(failing(t), Names{});
}

TEST(Power, ARetroreflectorsOwnPeakIsNoOutlier) {
  const io::SampleTable t =
      measured(matt(0.15), {.lights = {5, 25, 45, 65}, .step = 5, .azimuths = Grid::every(30, 180)}, 0);
  const io::SampleTable retro = changed(t, [&](std::size_t k, double v) {
    const Vec3<double> wi = direction(degrees(t.theta_i[k]), degrees(t.phi_i[k])),
                       wo = direction(degrees(t.theta_o[k]), degrees(t.phi_o[k]));
    const double apart = radians(std::acos(std::min(dot(wi, wo), 1.0))).degrees();
    return v + 20 * cosine(t.theta_i[k]) * std::exp(-(apart / 4) * (apart / 4));
  });
  EXPECT_EQ(finding(retro, "outliers").outcome, Outcome::pass) << finding(retro, "outliers").statement;
}

TEST(Power, AnAzimuthThatIsTurnedExplainsItAlone) {
  io::SampleTable t = measured(glossy(0.06, 0.9),
                               {.lights = {20, 40, 60}, .step = 15, .azimuths = Grid::every(15, 345)}, 0.002);
  for (double& phi : t.phi_o) phi += 180;
  EXPECT_EQ(failing(t), Names{"azimuth"});
  EXPECT_EQ(finding(t, "cosine_factor").outcome, Outcome::not_applicable);
}

TEST(Power, RadiansAreToldColumnByColumn) {
  io::SampleTable t = measured(glossy());
  for (auto* column : {&t.theta_i, &t.theta_o})
    for (double& x : *column) x = degrees(x).radians();
  const Finding f = finding(t, "angle_unit");
  EXPECT_EQ(f.outcome, Outcome::fail);
  EXPECT_THAT(f.statement, HasSubstr("theta_i (up to 1.222), theta_o (up to 1.396)"));
  EXPECT_EQ(failing(t), Names{"angle_unit"});
}

}  // namespace
}  // namespace brdf::sheet
