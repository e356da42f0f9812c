// Tests measured samples as a reflectance: interpolation, directions without measurements, and sample
// rotation.
#include <gtest/gtest.h>

#include "io/files/error.h"
#include "io/samples/degrees.h"
#include "measured/cells.h"
#include "tests/measured/samples.h"

namespace brdf::measured {
namespace {

Vec3<double> at(double theta, double phi) {
  return io::unit_vector(theta, phi);
}

double value(const Material& material, const Vec3<double>& wi, const Vec3<double>& wo) {
  double f = 0;
  eval(material, wi, wo, {&f, 1});
  return f;
}

TEST(Measured, RowsComeBackAndAreReciprocalAndIsotropic) {
  const Material truth = lobes({{0.2, 0.3, 0.15}}), wrong = lobes({{0.3, 0.2, 0.25}});
  const io::SampleTable table = scanned(truth, {10, 25, 40, 55, 70}, 0);
  const MeasuredReflectance measured(table, &wrong);
  EXPECT_EQ(measured.turning(), Turning::isotropic);
  double worst = 0;
  for (std::size_t k = 0; k < table.rows(); k += 7) {
    const Vec3<double> wi = at(table.theta_i[k], table.phi_i[k]), wo = at(table.theta_o[k], table.phi_o[k]);
    const Seen seen = measured.at(wi, wo);
    EXPECT_TRUE(seen.measured) << table.where(k);
    worst = std::max(worst, std::abs(seen.f[0] / table.values[0][k] - 1));
    // The fitted value and the ratio are reciprocal and isotropic.
    EXPECT_NEAR(measured.at(wo, wi).f[0], seen.f[0], 1e-9 * seen.f[0]);
    const Vec3<double> ti{-wi.y, wi.x, wi.z}, to{-wo.y, wo.x, wo.z};
    EXPECT_NEAR(measured.at(ti, to).f[0], seen.f[0], 1e-9 * seen.f[0]);
  }
  EXPECT_LT(worst, 0.01);
}

TEST(Measured, FillsMerlsCellsWhereItWasMeasured) {
  const Material truth = lobes({{0.2, 0.3, 0.15}}), wrong = lobes({{0.3, 0.2, 0.25}});
  const io::SampleTable cells = at_merl_cells(
      std::make_shared<const MeasuredReflectance>(scanned(truth, {10, 25, 40, 55, 70}, 0), &wrong));
  EXPECT_GT(cells.rows(), 400000u);
  EXPECT_LT(cells.rows(), 1000000u);  // of 1,458,000; a third is below the horizon
  double largest = 0;
  int checked = 0, off = 0;
  for (std::size_t k = 0; k < cells.rows(); k += 97) {
    EXPECT_LE(std::min(cells.theta_i[k], cells.theta_o[k]), 75) << k;
    const double f = value(truth, at(cells.theta_i[k], cells.phi_i[k]), at(cells.theta_o[k], cells.phi_o[k]));
    const double error = std::abs(cells.values[0][k] / f - 1);
    ++checked;
    off += error > 0.05;
    largest = std::max(largest, error);
  }
  EXPECT_LT(off, 0.05 * checked);
  EXPECT_GT(largest, 1e-6);
  EXPECT_LT(largest, 0.3);
  const io::SampleTable turned =
      scanned(lobes({{0.1, 0.4, 0.1, 0.5}}), {10, 40, 60}, 0, {0, 45, 90, 135}, 10);
  const auto seen = std::make_shared<const MeasuredReflectance>(turned);
  ASSERT_EQ(seen->turning(), Turning::turned);
  EXPECT_THROW(at_merl_cells(seen), InputError);
}

TEST(Measured, WhatWasNotMeasuredIsSaidAndNotInvented) {
  const Material truth = lobes({{0.2, 0.3, 0.15}}), wrong = lobes({{0.1, 0.15, 0.15}});
  synth::Instrument instrument;
  instrument.grid.parts = {"in_plane"};
  instrument.grid.theta_i = {15, 30, 45};
  const io::SampleTable table = synth::measure(truth, instrument);
  const MeasuredReflectance measured(table, &wrong);
  EXPECT_TRUE(measured.at(at(30, 180), at(40, 0)).measured);   // in the plane, between rows
  EXPECT_TRUE(measured.at(at(38, 180), at(45, 0)).measured);   // between incidences
  EXPECT_TRUE(measured.at(at(30, 180), at(31, 10)).measured);  // out of the plane, in the highlight
  const Vec3<double> wi = at(40, 180), beside = at(40, 90);
  EXPECT_FALSE(measured.at(wi, beside).measured);              // at right angles to the plane
  EXPECT_FALSE(measured.at(at(60, 180), at(60, 0)).measured);  // steeper than any light
  EXPECT_FALSE(measured.at(at(30, 180), at(88, 0)).measured);  // steeper than any viewer
  // The ratio of 2 is not extrapolated to these directions: it approaches 1.
  const double ratio = measured.at(wi, beside).f[0] / value(wrong, wi, beside);
  EXPECT_GT(measured.at(at(30, 180), at(30, 0)).f[0] / value(wrong, at(30, 180), at(30, 0)), 1.9);
  EXPECT_LT(ratio, 1.7);
}

TEST(Measured, AFitThatIsBlackInAChannelHasNoRatioThere) {
  io::SampleTable table = scanned(lobes({{0.2, 0.3, 0.15}}), {10, 30, 50}, 0);
  table.channels = {"r", "g"};
  table.values.emplace_back(table.rows(), 0.0);
  Material red = make_material(*find_form("lambert"), {"r", "g"});
  red.terms[0].weights = {{0.5}, {0}};
  const MeasuredReflectance measured(table, &red);
  const Seen seen = measured.at(at(30, 180), at(30, 0));
  EXPECT_TRUE(seen.measured);
  EXPECT_NEAR(seen.f[0] / value(lobes({{0.2, 0.3, 0.15}}), at(30, 180), at(30, 0)), 1, 0.05);
  EXPECT_LT(seen.f[1], 0.01);
}

TEST(Measured, TheScansRangeIsThatOfAllRows) {
  io::SampleTable table = scanned(lobes({{0.2, 0.3, 0.3}}), {10, 30, 50}, 0);
  for (std::size_t k = 0; k < table.rows(); ++k) {  // the mirror direction alone: no half vector is tilted
    table.theta_o[k] = table.theta_i[k];
    table.phi_o[k] = table.phi_i[k] + 180;
  }
  const MeasuredReflectance measured(table);
  EXPECT_EQ(measured.range().inner, 50);
  EXPECT_EQ(measured.range().outer, 50);
}

TEST(Measured, FarApartIncidencesLeaveAGap) {
  const Material truth = lobes({{0.2, 0.3, 0.1}});
  const io::SampleTable table = scanned(truth, {0, 60}, 0.01);
  const MeasuredReflectance measured(table, &truth);
  EXPECT_TRUE(measured.at(at(0, 0), at(30, 0)).measured);
  EXPECT_TRUE(measured.at(at(58, 180), at(60, 0)).measured);
  EXPECT_FALSE(measured.at(at(30, 180), at(30, 0)).measured);
}

TEST(Measured, APerfectFitIsLeftAsItIs) {
  const Material truth = lobes({{0.2, 0.3, 0.1}});
  const MeasuredReflectance measured(scanned(truth, {0, 20, 40, 60}, 0.05), &truth);
  double worst = 0;
  for (double theta = 0; theta <= 60; theta += 4) {
    for (double phi = 0; phi < 180; phi += 30) {
      const Seen seen = measured.at(at(30, 180), at(theta, phi));
      EXPECT_TRUE(seen.measured) << theta << ' ' << phi;
      worst = std::max(worst, std::abs(seen.f[0] / value(truth, at(30, 180), at(theta, phi)) - 1));
    }
  }
  EXPECT_LT(worst, 0.02);  // the noise is 0.05
}

TEST(Measured, ATurnedSampleKeepsItsAzimuth) {
  const Material brushed = lobes({{0.1, 0.3, 0.3, 0.12}}), round = lobes({{0.1, 0.3, 0.2}});
  const std::vector<double> azimuths{0, 30, 60, 90, 120, 150};
  const MeasuredReflectance measured(scanned(brushed, {0, 20, 40, 60}, 0.01, azimuths, 10), &round);
  EXPECT_EQ(measured.turning(), Turning::turned);
  double square = 0, of_fit = 0, count = 0;
  for (double azimuth = 0; azimuth < 360; azimuth += 15) {
    for (double theta = 10; theta <= 50; theta += 10) {
      const Vec3<double> wi = at(30, azimuth), wo = at(theta, azimuth + 170);
      const Seen seen = measured.at(wi, wo);
      EXPECT_TRUE(seen.measured) << azimuth << ' ' << theta;
      const double truth = value(brushed, wi, wo);
      square += std::pow(seen.f[0] / truth - 1, 2);
      of_fit += std::pow(value(round, wi, wo) / truth - 1, 2);
      ++count;
    }
  }
  EXPECT_LT(std::sqrt(square / count), 0.05);
  EXPECT_GT(std::sqrt(of_fit / count), 0.2);
  // A sample that looks the same from every azimuth needs no turning.
  EXPECT_EQ(MeasuredReflectance(scanned(round, {0, 30, 60}, 0.01, azimuths, 10), &brushed).turning(),
            Turning::turned);  // with a fit that is not isotropic
  EXPECT_EQ(MeasuredReflectance(scanned(round, {0, 30, 60}, 0.01, azimuths, 10), &round).turning(),
            Turning::isotropic);
}

TEST(Measured, AWrongMaterialIsNoHelp) {
  const Material truth = lobes({{0.3, 0.1, 0.4}}), wrong = lobes({{0.01, 1, 0.03}});
  const io::SampleTable table = scanned(truth, {0, 20, 40, 60}, 0.01);
  const auto error = [&](const MeasuredReflectance& measured) {
    double worst = 0;
    for (double theta = 0; theta < 60; theta += 2.5)
      worst = std::max(worst, std::abs(measured.at(at(30, 180), at(theta, 5)).f[0] /
                                           value(truth, at(30, 180), at(theta, 5)) -
                                       1));
    return worst;
  };
  using Beside = MeasuredReflectance::Beside;
  EXPECT_LT(error(MeasuredReflectance(table, &wrong, Beside::likeliest)), 0.03);
  EXPECT_GT(error(MeasuredReflectance(table, &wrong)), 0.06);
  EXPECT_LT(error(MeasuredReflectance(table, &truth, Beside::likeliest)), 0.01);
}

TEST(Measured, HalfVectorsOfOneAzimuthAreNoTurn) {
  const Material truth = lobes({{0.2, 0.3, 0.2}}), one = lobes({{0.2, 0.3, 0.15}});
  io::SampleTable table;
  table.channels = {"f"};
  table.values.resize(1);
  for (double theta_h = 0; theta_h < 60; theta_h += 5) {
    for (double theta_d = 0; theta_d < 60; theta_d += 5) {
      for (double phi_d = 0; phi_d < 180; phi_d += 20) {
        const Vec3<double> d = at(theta_d, phi_d);  // about the half vector, which leans towards azimuth 0
        const double s = io::sin_degrees(theta_h), c = io::cos_degrees(theta_h);
        const Vec3<double> wi{c * d.x + s * d.z, d.y, c * d.z - s * d.x},
            wo{s * d.z - c * d.x, -d.y, c * d.z + s * d.x};
        if (wi.z < 0.1 || wo.z < 0.1) continue;
        table.add_directions(wi, wo);
        table.values[0].push_back(value(truth, wi, wo));
      }
    }
  }
  const MeasuredReflectance measured(table, &one);
  EXPECT_EQ(measured.turning(), Turning::isotropic);
  EXPECT_TRUE(measured.at(at(30, 90), at(35, 260)).measured);
}

TEST(Measured, ValuesOfNothingAreNoTrouble) {
  const Material truth = lobes({{0.05, 0.3, 0.1}});
  io::SampleTable table = scanned(truth, {0, 30, 60}, 0.01, {0}, 10);
  for (std::size_t k = 0; k < table.rows(); k += 3) table.values[0][k] = k % 2 ? 0 : -0.01;
  const MeasuredReflectance measured(table, &truth);
  for (double theta = 0; theta < 90; theta += 3) {
    const double f = measured.at(at(30, 180), at(theta, 20)).f[0];
    EXPECT_TRUE(std::isfinite(f) && f >= 0) << theta;
  }
  EXPECT_EQ(measured.at(at(30, 180), Vec3<double>{0, 0.6, -0.8}).f[0], 0);
}

TEST(Measured, IsAReflectanceLikeAnyOther) {
  Material truth = make_material(*find_form("lambert"), {"465nm", "525nm", "630nm"});
  for (std::size_t c = 0; c < 3; ++c) truth.terms[0].weights[c] = {0.2 + 0.1 * double(c)};
  const io::SampleTable table = scanned(truth, {0, 30, 60}, 0.001, {0}, 10);
  // Channels are matched by name, and by colour.
  Material rgb = make_material(*find_form("lambert"));
  rgb.terms[0].weights = {{0.4}, {0.3}, {0.2}};
  const auto measured = std::make_shared<const MeasuredReflectance>(table, &rgb);
  const Material material = material_of(measured);
  EXPECT_EQ(material.channels, truth.channels);
  const Vec3<double> wi = at(25, 180), wo = at(30, 40);
  std::vector<double> f(3), expected(3);
  eval(material, wi, wo, f);
  eval(truth, wi, wo, expected);
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_EQ(f[c], measured->at(wi, wo).f[c]);
    EXPECT_NEAR(f[c], expected[c], 2e-3 * expected[c]);
  }
  // Without a fit, the values are interpolated about the mean of each channel.
  EXPECT_NEAR(MeasuredReflectance(table).at(wi, wo).f[2], expected[2], 2e-3 * expected[2]);
}

}  // namespace
}  // namespace brdf::measured
