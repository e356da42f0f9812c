// A clean synthetic measurement passes all checks. With one planted fault, the sheet names this fault and
// no other.
#include "sheet/data_sheet.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <random>

#include "brdf/forms.h"
#include "brdf/integrals.h"
#include "brdf/material.h"
#include "io/formats/merl.h"
#include "io/formats/read.h"
#include "io/samples/degrees.h"
#include "tables.h"

namespace brdf::sheet {
namespace {

io::SampleTable clean_table(double noise = 0.03) {
  Term term = make_term(cook_torrance{}, 1);
  term.shape[0] = {0.4, 0.4};
  term.weights[0] = {0.5, 0.5, 0.3};
  const Material material{{"fr"}, {term}};
  io::SampleTable t;
  t.channels = {"fr"};
  t.values.resize(1);
  t.sigma.resize(1);
  t.source = "table.csv";
  std::mt19937 random(5);
  for (const double theta_i : {10.0, 30.0, 50.0, 70.0})
    for (int theta_o = 0; theta_o <= 80; theta_o += 5)
      for (int phi_o = 0; phi_o <= 180; phi_o += 10) {
        if (theta_o == 0 && phi_o > 0) continue;
        std::vector<double> f(1);
        eval(material, direction(degrees(theta_i), radians(kPi)), direction(degrees(theta_o), degrees(phi_o)),
             f);
        const double jitter = noise * (2 * double(random()) / double(random.max()) - 1);
        t.add_directions(theta_i, 180, theta_o, phi_o);
        t.values[0].push_back(f[0] * (1 + jitter));
        t.lines.push_back(std::uint32_t(t.lines.size() + 2));
      }
  return t;
}

TEST(DataSheet, NamesACleanTableClean) {
  EXPECT_EQ(failing(clean_table()), Names{});
}

Outcome outcome_of(const io::SampleTable& t, const char* check) {
  return finding(data_sheet(t), check).outcome;
}

// A sentence about what a check looked at needs values that would have shown the opposite.
TEST(DataSheet, ClaimsNothingOfValuesThatShowNothing) {
  io::SampleTable same = clean_table();
  for (double& v : same.values[0]) v = 0.3;
  for (const char* check : {"stuck", "saturation", "polar_angle"})
    EXPECT_EQ(outcome_of(same, check), Outcome::undecided) << check;
  io::SampleTable dark = clean_table();
  for (double& v : dark.values[0]) v = 0;
  io::SampleTable inverted = clean_table();
  for (double& v : inverted.values[0]) v = -v;
  for (const io::SampleTable& t : {dark, inverted}) {
    EXPECT_EQ(outcome_of(t, "negative"), Outcome::fail);
    EXPECT_NE(finding(data_sheet(t), "negative").statement.find("no value is above 0"), std::string::npos);
    for (const char* check : {"quantity", "energy", "outliers"})
      EXPECT_EQ(outcome_of(t, check), Outcome::not_applicable);
  }
  io::SampleTable noise = clean_table();
  std::mt19937 random(6);
  for (double& v : noise.values[0]) v = std::pow(10.0, 12 * double(random()) / double(random.max()) - 6);
  EXPECT_NE(outcome_of(noise, "outliers"), Outcome::pass);
  io::SampleTable one;
  one.set_channels({"fr"});
  one.add_directions(30, 180, 30, 0);
  one.values[0] = {1.2};
  for (const char* check : {"outliers", "saturation", "stuck", "invented"})
    EXPECT_EQ(outcome_of(one, check), Outcome::not_applicable) << check;
}

TEST(DataSheet, NamesANegativeValue) {
  io::SampleTable t = clean_table();
  t.values[0][100] = -0.01;
  const DataSheet sheet = data_sheet(t);
  EXPECT_EQ(finding(sheet, "negative").outcome, Outcome::fail);
  EXPECT_NE(finding(sheet, "negative").statement.find("line 102"), std::string::npos);
}

TEST(DataSheet, NamesExchangedColumns) {
  io::SampleTable t = clean_table();
  // The table keeps only rows that a reader accepts: polar angles up to 90 degrees.
  io::SampleTable u = t;
  for (auto* column : {&u.theta_i, &u.phi_i, &u.theta_o, &u.phi_o}) column->clear();
  u.values[0].clear();
  u.lines.clear();
  for (std::size_t k = 0; k < t.rows(); ++k) {
    if (t.phi_o[k] > 90) continue;
    u.add_directions(t.theta_i[k], t.phi_i[k], t.phi_o[k], t.theta_o[k]);
    u.values[0].push_back(t.values[0][k]);
    u.lines.push_back(std::uint32_t(k));
  }
  const auto names = failing(u);
  EXPECT_NE(std::find(names.begin(), names.end(), "directions"), names.end());
}

TEST(DataSheet, NamesAFactorOfTheCosine) {
  io::SampleTable t = clean_table();
  for (std::size_t k = 0; k < t.rows(); ++k) t.values[0][k] *= std::cos(t.theta_i[k] * kPi / 180);
  const DataSheet sheet = data_sheet(t);
  EXPECT_EQ(finding(sheet, "cosine_factor").outcome, Outcome::fail);
  EXPECT_NE(finding(sheet, "cosine_factor").statement.find("cos_i"), std::string::npos);
  EXPECT_NEAR(finding(sheet, "cosine_factor").value, 1, 0.2);
}

TEST(DataSheet, NamesDuplicatedRows) {
  io::SampleTable t = clean_table();
  for (const std::size_t k : {7u, 8u, 9u}) {
    for (auto* column : {&t.theta_i, &t.phi_i, &t.theta_o, &t.phi_o}) column->push_back((*column)[k]);
    t.values[0].push_back(t.values[0][k]);
    t.lines.push_back(2000);
  }
  EXPECT_EQ(failing(t), Names{"duplicates"});
  EXPECT_EQ(finding(data_sheet(t), "duplicates").value, 3);
  t.lines.assign(t.rows(), 7);  // a line that holds several rows is named once
  const std::string statement = finding(data_sheet(t), "duplicates").statement;
  EXPECT_EQ(statement.find("line 7"), statement.rfind("line 7")) << statement;
}

TEST(DataSheet, NamesOneOutlierByItsRow) {
  io::SampleTable t = clean_table();
  t.values[0][200] *= 10;
  const DataSheet sheet = data_sheet(t);
  EXPECT_EQ(finding(sheet, "outliers").value, 1);
  EXPECT_NE(finding(sheet, "outliers").statement.find("line 202"), std::string::npos);
}

// Sets the rows of three neighbouring directions, far from the mirror direction.
io::SampleTable with_cluster(double first, double second, double third) {
  io::SampleTable t = clean_table();
  for (std::size_t k = 0; k < t.rows(); ++k) {
    if (t.theta_i[k] != 50 || t.phi_o[k] != 90) continue;
    if (t.theta_o[k] == 40) t.values[0][k] = first;
    if (t.theta_o[k] == 45) t.values[0][k] = second;
    if (t.theta_o[k] == 50) t.values[0][k] = third;
  }
  return t;
}

// Rows that are each other's neighbours agree with each other, which shows nothing.
TEST(DataSheet, NamesNumbersForMissingMeasurementsThatAreNeighbours) {
  for (const double mark :
       {99.9, 99.99, 999.0, 9999.0, 99999.0, 1e20, 999 / kPi, 99.9 / (100 * kPi) * 1000}) {
    const DataSheet sheet = data_sheet(with_cluster(mark, mark, mark));
    EXPECT_EQ(finding(sheet, "fill").outcome, Outcome::fail) << mark;
    EXPECT_EQ(finding(sheet, "fill").value, 3) << mark;
    EXPECT_EQ(finding(sheet, "fill").statement.find("no fill values"), std::string::npos) << mark;
  }
  io::SampleTable dim = with_cluster(99.9, 99.9, 99.9);
  for (double& value : dim.values[0]) value = value == 99.9 ? 9.99 : value / 10;
  EXPECT_EQ(finding(dim, "fill").value, 3);
  // Two different marks in one table, and a value of nines that is no larger than the others.
  EXPECT_EQ(finding(with_cluster(999, 999, 9999), "fill").value, 2);
  io::SampleTable of_nines = clean_table();
  for (const std::size_t k : {100u, 200u, 300u}) of_nines.values[0][k] = 0.999;
  EXPECT_EQ(finding(of_nines, "fill").outcome, Outcome::pass);
}

TEST(DataSheet, AClusterApartFromAllOthersIsNoEvidenceOfAgreement) {
  io::SampleTable cluster = measured(matt(0.3), {.lights = {15, 45}, .azimuths = Grid::every(30, 180)});
  ASSERT_EQ(finding(cluster, "outliers").outcome, Outcome::pass);
  for (const double step : {0., 1., 2.}) {
    cluster.add_directions(45, 180, 40.5 + step, 90);
    cluster.values[0].push_back(950 + 30 * step);
    cluster.lines.push_back(std::uint32_t(cluster.lines.size() + 2));
  }
  const Finding apart = finding(cluster, "outliers");
  EXPECT_EQ(apart.outcome, Outcome::undecided) << apart.statement;
  EXPECT_EQ(apart.value, 3);
  EXPECT_NE(apart.statement.find("3 rows agree with each other only"), std::string::npos) << apart.statement;
  EXPECT_EQ(apart.statement.find("every value agrees"), std::string::npos);
  EXPECT_NE(finding(with_cluster(950, 1003, 987), "outliers").outcome, Outcome::pass);
  // A highlight of few rows agrees with the rows of no other direction either, and is no fault.
  for (const double alpha : {0.02, 0.05, 0.15})
    EXPECT_EQ(finding(measured(glossy(0.05, 0.9, 0.06, alpha)), "outliers").outcome, Outcome::pass) << alpha;
}

TEST(DataSheet, MeasuresTheNoiseFloor) {
  // Both of two values vary uniformly by +-10 %: the median of |difference| is 5.9 %, and less for
  // interpolated values.
  const double floor = finding(data_sheet(clean_table(0.1)), "noise_floor").value;
  EXPECT_GT(floor, 0.04);
  EXPECT_LT(floor, 0.08);
}

TEST(DataSheet, ATurnedSampleShowsItsAnisotropyAndItsNoise) {
  Term term = make_term(ward{}, 1);
  term.weights[0] = {0.2, 0.15};
  std::mt19937 random(7);
  for (const double alpha_y : {0.1, 0.3}) {
    term.shape[0] = {0.1, alpha_y};
    io::SampleTable t = clean_table(0);
    const std::size_t rows = t.rows();
    for (const double turn : {45.0, 90.0})
      for (std::size_t k = 0; k < rows; ++k) {
        for (auto* angles : {&t.theta_i, &t.theta_o}) angles->push_back((*angles)[k]);
        for (auto* angles : {&t.phi_i, &t.phi_o}) angles->push_back((*angles)[k] + turn);
        t.values[0].push_back(0);
        t.lines.push_back(std::uint32_t(t.lines.size() + 2));
      }
    for (std::size_t k = 0; k < t.rows(); ++k) {
      std::vector<double> f(1);
      const auto at = [](double theta, double phi) { return direction(degrees(theta), degrees(phi)); };
      eval(Material{{"fr"}, {term}}, at(t.theta_i[k], t.phi_i[k]), at(t.theta_o[k], t.phi_o[k]), f);
      t.values[0][k] = f[0] * (1 + 0.1 * (2 * double(random()) / double(random.max()) - 1));
    }
    const DataSheet sheet = data_sheet(t);
    EXPECT_EQ(finding(sheet, "isotropy").statement.starts_with("the sample is anisotropic"), alpha_y != 0.1)
        << finding(sheet, "isotropy").statement;
    EXPECT_GT(finding(sheet, "noise_floor").value, 0.04);
    EXPECT_LT(finding(sheet, "noise_floor").value, 0.08);
    EXPECT_EQ(failing(t), Names{}) << alpha_y;
  }
}

TEST(DataSheet, IntegralHoldsTheTruthWithinItsBound) {
  io::SampleTable t = clean_table(0);
  for (double& v : t.values[0]) v = 0.8 / kPi;  // Lambert
  const DataSheet sheet = data_sheet(t);
  for (const MeasuredAlbedo& a : sheet.albedo) {
    EXPECT_NEAR(a.value[0], 0.8, a.bound[0] + 1e-12);
    EXPECT_LT(a.bound[0], 0.05);
    EXPECT_GT(a.coverage, 0.95);
  }
}

TEST(DataSheet, WhatIsBarelyCoveredIsUndecidedWithItsNumber) {
  io::SampleTable t = clean_table(0);
  const std::vector<double> theta_o = t.theta_o, phi_o = t.phi_o;
  std::size_t kept = 0;  // one plane
  for (std::size_t k = 0; k < theta_o.size(); ++k) {
    if (phi_o[k] != 0) continue;
    for (auto* column : {&t.theta_i, &t.phi_i, &t.theta_o, &t.phi_o, &t.values[0]})
      (*column)[kept] = (*column)[k];
    ++kept;
  }
  for (auto* column : {&t.theta_i, &t.phi_i, &t.theta_o, &t.phi_o, &t.values[0]}) column->resize(kept);
  t.lines.resize(kept);
  const DataSheet sheet = data_sheet(t);
  EXPECT_EQ(finding(sheet, "coverage").outcome, Outcome::undecided);
  EXPECT_LT(finding(sheet, "coverage").value, 0.2);
  EXPECT_EQ(finding(sheet, "energy").outcome, Outcome::undecided);
  EXPECT_GT(finding(sheet, "energy").value, 0);
  EXPECT_EQ(failing(t), Names{});
}

TEST(DataSheet, AnIntegralWhoseBoundReachesAboveOneIsUndecided) {
  io::SampleTable t = clean_table(0);
  for (std::size_t k = 0; k < t.rows(); ++k) t.values[0][k] = (k % 2 ? 0.9 : 1.0) / kPi;
  EXPECT_EQ(finding(data_sheet(t), "energy").outcome, Outcome::undecided);
  for (double& v : t.values[0]) v = 1.3 / kPi;
  const DataSheet bright = data_sheet(t);
  EXPECT_EQ(finding(bright, "energy").outcome, Outcome::fail);
  // Nothing is proved beyond the outermost ring. The lower bound is therefore below the truth by the share
  // of this ring.
  EXPECT_NE(finding(bright, "energy").statement.find("at least 1.17"), std::string::npos)
      << finding(bright, "energy").statement;
  for (double& v : t.values[0]) v = 0.5 / kPi;
  EXPECT_EQ(finding(data_sheet(t), "energy").outcome, Outcome::pass);
}

TEST(DataSheet, ListsEveryOutlierAndSetsThoseBeyondTheLargestAngleApart) {
  io::SampleTable t = clean_table();
  t.channels = {"r", "b"};
  t.values.push_back(t.values[0]);
  t.sigma.resize(2);
  std::vector<std::size_t> planted;
  for (std::size_t k = 100; k < t.rows(); k += 130) {
    t.values[1][k] *= 10;
    planted.push_back(k);
  }
  const DataSheet sheet = data_sheet(t, {.max_theta = 60});
  const Finding& found = finding(sheet, "outliers");
  ASSERT_EQ(found.rows.size(), planted.size());
  std::size_t inside = 0;
  for (std::size_t n = 0; n < planted.size(); ++n) {
    const NamedRow& row = found.rows[n];
    EXPECT_EQ(row.row, planted[n]);
    EXPECT_EQ(row.line, planted[n] + 2);
    EXPECT_EQ(row.channel, "b");
    EXPECT_NEAR(row.expected, t.values[0][planted[n]], 0.5 * row.expected);
    EXPECT_EQ(row.apart, row.theta_i > 60 || row.theta_o > 60);
    inside += !row.apart;
  }
  EXPECT_GT(inside, 0u);
  EXPECT_LT(inside, planted.size());
  EXPECT_EQ(found.value, double(inside));
  EXPECT_NE(found.statement.find("beyond 60 degrees"), std::string::npos) << found.statement;
}

TEST(DataSheet, AFactorOfThreeIsNoOutlierWhereThereIsNoLight) {
  // A highlight on a black surface. The dark level is steady to a tenth, except for occasional jumps.
  Term term = make_term(cook_torrance{}, 1);
  term.shape[0] = {0.1, 0.1};
  term.weights[0] = {0, 1, 0.5};
  io::SampleTable t = clean_table(0);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0, 1);
  std::size_t jumps = 0;
  for (std::size_t k = 0; k < t.rows(); ++k) {
    std::vector<double> f(1);
    eval(Material{{"fr"}, {term}}, direction(degrees(t.theta_i[k]), radians(kPi)),
         direction(degrees(t.theta_o[k]), degrees(t.phi_o[k])), f);
    const bool jump = uniform(random) < 0.08;
    jumps += jump;
    t.values[0][k] = 3e-3 * (jump ? 4 : 1 + 0.1 * uniform(random)) + f[0];
  }
  EXPECT_GT(jumps, 50u);
  EXPECT_EQ(finding(data_sheet(t), "outliers").value, 0);
  // A value that departs by more than the dark level does is an outlier in any place.
  const auto darkest = std::min_element(t.values[0].begin(), t.values[0].end());
  *darkest = 0.3;
  EXPECT_EQ(finding(data_sheet(t), "outliers").value, 1);
}

TEST(DataSheet, ARoughSurfaceIsNoTableOfTheOtherAzimuthConvention) {
  io::SampleTable t = clean_table(0);
  Term term = make_term(oren_nayar_full{}, 1);
  term.shape[0] = {1.2};
  term.weights[0] = {0.8};
  for (std::size_t k = 0; k < t.rows(); ++k) {
    std::vector<double> f(1);
    eval(Material{{"fr"}, {term}}, direction(degrees(t.theta_i[k]), radians(kPi)),
         direction(degrees(t.theta_o[k]), degrees(t.phi_o[k])), f);
    t.values[0][k] = f[0];
  }
  EXPECT_NE(finding(data_sheet(t), "azimuth").outcome, Outcome::fail);
}

TEST(DataSheet, ANarrowScanIsToldFromRadians) {
  io::SampleTable t = clean_table();
  for (auto* column : {&t.theta_i, &t.phi_i, &t.theta_o, &t.phi_o})
    for (double& x : *column) x = x * kPi / 180;
  EXPECT_EQ(failing(t), Names{"angle_unit"});
  // A scan about the normal in steps of a hundredth of a degree must not be taken for radians.
  for (std::size_t k = 0; k < t.rows(); ++k) {
    t.theta_i[k] = t.phi_i[k] = t.phi_o[k] = 0;
    t.theta_o[k] = 0.01 * double(k % 150);
  }
  EXPECT_EQ(finding(data_sheet(t), "angle_unit").outcome, Outcome::pass);
}

io::SampleTable merl_table(const Material& material) {
  io::SampleTable t;
  t.channels = {"r", "g", "b"};
  t.values.resize(3);
  t.sigma.resize(3);
  t.format = "merl";
  t.source = "table.binary";
  io::merl::add_cell_directions(t);
  std::vector<double> f(3);
  for (auto& values : t.values) values.reserve(t.rows());
  for (std::size_t k = 0; k < t.rows(); ++k) {
    eval(material, io::unit_vector(t.theta_i[k], t.phi_i[k]), io::unit_vector(t.theta_o[k], t.phi_o[k]), f);
    for (std::size_t c = 0; c < 3; ++c) t.values[c].push_back(f[c]);
  }
  return t;
}

TEST(DataSheet, OfAMerlFileKnowsItsCells) {
  Material material = make_material(cook_torrance{});
  material.terms[0].shape[0] = {0.2, 0.2};
  io::SampleTable t = merl_table(material);
  const std::size_t outlier = t.rows() / 2;
  t.values[1][outlier] *= 20;
  const auto start = std::chrono::steady_clock::now();
  const DataSheet sheet = data_sheet(t);
  EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), 30);
  EXPECT_EQ(finding(sheet, "coverage").value, 1);
  ASSERT_EQ(finding(sheet, "outliers").rows.size(), 1u);
  EXPECT_EQ(finding(sheet, "outliers").rows[0].row, outlier);
  EXPECT_EQ(finding(sheet, "outliers").rows[0].channel, "g");
  EXPECT_EQ(finding(sheet, "energy").outcome, Outcome::pass);
  AlbedoOptions options;
  for (const MeasuredAlbedo& a : sheet.albedo) {
    const double truth = directional_albedo(material, degrees(a.theta_i), {}, options)[0].value;
    EXPECT_NEAR(a.value[0], truth, a.bound[0] + 0.005 * truth) << a.theta_i;
    EXPECT_LT(a.bound[0], 0.02 * truth) << a.theta_i;
  }
  // Half of the cells give half of the coverage.
  const std::size_t half = t.rows() / 2;
  for (auto* column : {&t.theta_i, &t.phi_i, &t.theta_o, &t.phi_o, &t.values[0], &t.values[1], &t.values[2]})
    column->resize(half);
  EXPECT_NEAR(finding(data_sheet(t), "coverage").value, 0.5, 1e-6);
  EXPECT_EQ(finding(data_sheet(t), "coverage").outcome, Outcome::undecided);
}

TEST(DataSheet, SaysWhatTheTableDoesNotAllow) {
  const DataSheet sheet = data_sheet(clean_table());
  EXPECT_EQ(finding(sheet, "isotropy").outcome, Outcome::not_applicable);
  EXPECT_FALSE(finding(sheet, "isotropy").statement.empty());
}

std::string measured_file(const char* name) {
  const char* folder = std::getenv("BRDF_DATA_DIR");
  return folder ? std::string(folder) + "/measured/" + name : "";
}

// Asymmetry is noise only of a sample that is known to be isotropic.
TEST(DataSheet, SymmetricRowsGiveNoiseOnlyIfTheSampleIsIsotropic) {
  Scatter s;
  s.neighbours.value = 0.01;
  s.agreements = {{"mirrored", 0.3, 100, true}};
  EXPECT_EQ(s.value(), 0.3);
  EXPECT_EQ(s.least(), 0.01);
  s.isotropy = Isotropy::seen;
  EXPECT_EQ(s.least(), 0.3);
  EXPECT_EQ(s.value(false), 0.01);
  s.isotropy = Isotropy::refuted;
  EXPECT_EQ(s.value(), 0.01);
  s.isotropy = Isotropy::unknown;
  s.neighbours.value.reset();
  EXPECT_EQ(s.value(), 0.3);
  EXPECT_EQ(s.least(), std::nullopt);
  s.agreements[0].value = 0.1;
  EXPECT_EQ(s.least(), 0.1);
}

// Mirrored rows far below the neighbours' noise show that this noise is the shape of a lobe.
TEST(DataSheet, SymmetricRowsRefuteTheNoiseOfNeighbours) {
  Scatter s;
  s.neighbours.value = 0.2;
  s.agreements = {{"mirrored", 0.01, 16, true}};
  for (const Isotropy isotropy : {Isotropy::unknown, Isotropy::seen, Isotropy::refuted}) {
    s.isotropy = isotropy;
    EXPECT_EQ(s.value(), 0.01);
    EXPECT_EQ(s.least(), 0.01);
  }
  s.agreements[0].value = 0.08;  // 16 pairs give a scale within 60 %
  EXPECT_EQ(s.value(), 0.2);
  s.agreements = {{"repeated", 0.01, 16, false}};  // repeated rows share what differs between directions
  EXPECT_EQ(s.value(), 0.2);
}

TEST(DataSheet, OfAnAnisotropicSampleThatWasNotRotatedHasNoNoiseOfMirroredRows) {
  Material m = make_material(*find_form("ward"), {"f"});
  m.terms[0].weights[0] = {0.05, 0.2};
  m.terms[0].shape[0] = {0.25, 0.7};
  m.terms[0].tangent_phi = degrees(40);
  const io::SampleTable t = measured(m, {.lights = {15, 45}, .azimuths = Grid::every(5, 355)}, 0.01);
  const DataSheet sheet = data_sheet(t);
  EXPECT_GT(sheet.scatter.value().value_or(0), 0.1);
  EXPECT_NEAR(sheet.scatter.least().value_or(0), 0.01, 0.003);
  EXPECT_THAT(finding(sheet, "noise_floor").statement,
              testing::HasSubstr("the sample is not isotropic, which no rotation tests"));
}

TEST(DataSheet, OfWhitePaperIsCleanWithItsNoiseFloor) {
  const std::string path = measured_file("rgl_paper_white.csv");
  if (path.empty()) GTEST_SKIP() << "BRDF_DATA_DIR is not set: no measured samples";
  const io::SampleTable t = io::read_samples(path);
  EXPECT_EQ(failing(t), Names{});
  const DataSheet sheet = data_sheet(t);
  // The published values are smoothed: neighbours differ by only 0.1 %. Exchanging light and viewer shows
  // the remaining noise.
  EXPECT_LT(sheet.scatter.neighbours.value.value_or(1), 0.002);
  EXPECT_NEAR(finding(sheet, "noise_floor").value, 0.018, 0.009);
  EXPECT_NE(finding(sheet, "noise_floor").statement.find("neighbours agree better than this noise permits"),
            std::string::npos);
  EXPECT_GT(finding(sheet, "energy").value, 0.9);
  EXPECT_LT(finding(sheet, "energy").value, 1.01);
}

}  // namespace
}  // namespace brdf::sheet
