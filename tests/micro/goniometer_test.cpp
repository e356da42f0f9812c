// The virtual goniometer against surfaces with a known result (flat, perfectly reflecting, white), its
// energy balance, reciprocity and reproducibility.
#include "micro/goniometer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "brdf/material.h"

namespace brdf::micro {
namespace {

Simulation mirrors(double alpha, std::int64_t rays = 20000) {
  Simulation s;
  s.geometry = HeightField{.alpha_x = alpha, .alpha_y = alpha, .size = 128, .correlation_length = 6};
  s.rays = rays;
  return s;
}

Simulation lambert_grooves(double sigma, double rho, std::int64_t rays = 20000) {
  Simulation s;
  s.geometry = Grooves{GrooveAngles::oren_nayar, sigma, 512};
  s.facets = {.reflection = Reflection::lambert, .rho = rho};
  s.rays = rays;
  return s;
}

TEST(Cells, CoverTheHemisphereOnce) {
  for (const double width : {2.0, 5.0, 10.0}) {
    const Cells cells(degrees(width));
    double sum = 0;
    for (int k = 0; k < cells.size(); ++k) {
      sum += cells[k].projected_solid_angle();
      const Vec centre = cells[k].centre();
      const double c = std::cos(0.4), sine = std::sin(0.4);
      const Vec turned{c * centre.x - sine * centre.y, sine * centre.x + c * centre.y, centre.z};
      EXPECT_EQ(cells.find(turned, radians(0.4)), k);
      for (const double u : {0.01, 0.99}) {
        for (const double v : {0.01, 0.99}) EXPECT_EQ(cells.find(cells[k].point(u, v)), k);
      }
    }
    EXPECT_NEAR(sum, kPi, 1e-12);
  }
}

TEST(Goniometer, FlatLambertianSurfaceIsRhoOverPi) {
  Simulation s = lambert_grooves(1e-6, 0.7, 40000);
  const Radiance f =
      measure_radiance(s, {{radians(0.9), radians(1.0)}}, {{radians(1.1), radians(4.0)}})[0][0];
  EXPECT_NEAR(f.total.mean, 0.7 / kPi, 1e-5);
  const Scatter scatter = measure_scatter(s, {{radians(0.9), radians(1.0)}}, Cells(15_deg))[0];
  for (const Estimate& e : scatter.total) EXPECT_NEAR(e.mean, 0.7 / kPi, 6 * e.standard_error);
  EXPECT_NEAR(scatter.albedo.mean, 0.7, 1e-9);
}

TEST(Goniometer, FlatMirrorSendsEverythingIntoTheMirrorDirection) {
  const Cells cells(2_deg);
  const Scatter scatter = measure_scatter(mirrors(1e-4, 400), {{radians(0.71), radians(2.0)}}, cells)[0];
  const int mirror = cells.find(direction(radians(0.71), radians(2.0 + kPi)), radians(2.0));
  EXPECT_NEAR(scatter.f[0][mirror].mean, 1 / cells[mirror].projected_solid_angle(), 1e-9 / 1e-3);
  EXPECT_NEAR(scatter.account.escaped[0], 1, 1e-12);
}

// A perfect reflector returns every ray after at most 64 reflections, also at grazing incidence.
TEST(Goniometer, PerfectReflectorLosesNothing) {
  for (const double alpha : {0.1, 0.5, 1.0}) {
    for (const Scatter& s : measure_scatter(mirrors(alpha, 30000),
                                            {{}, {radians(1.0), radians(0.3)}, {radians(1.5), radians(2.0)}},
                                            Cells(radians(0.2)))) {
      EXPECT_EQ(s.account.leaked, 0);
      EXPECT_LE(s.account.lost(), 1e-5) << alpha << ' ' << s.incidence.theta.degrees();
      EXPECT_NEAR(s.albedo.mean, 1 - s.account.lost(), 1e-12);
      EXPECT_GT(s.account.escaped[0], 0.4);
    }
  }
}

TEST(Goniometer, LambertianGroovesReflectAllOfWhiteLight) {
  const Account a =
      measure_scatter(lambert_grooves(0.35, 1), {{radians(1.0), {}}}, Cells(radians(0.2)))[0].account;
  EXPECT_EQ(a.leaked, 0);
  EXPECT_LE(a.beyond, 2e-5);
  EXPECT_NEAR(a.albedo(), 1 - a.lost(), 1e-12);
  EXPECT_GT(a.escaped[1], 0.03);  // interreflection exists
  // The deepest grooves of the wide distribution hold light for more than 64 reflections. This light is
  // counted as beyond.
  const Account deep =
      measure_scatter(lambert_grooves(0.6, 1), {{radians(1.0), {}}}, Cells(radians(0.2)))[0].account;
  EXPECT_EQ(deep.leaked, 0);
  EXPECT_LE(deep.beyond, 2e-3);
}

TEST(Goniometer, AccountsForEveryShareOfThePower) {
  Simulation s = mirrors(0.5);
  s.facets.eta = 1.5;
  s.max_bounces = 2;
  const Account a = measure_scatter(s, {{radians(1.2), {}}}, Cells(radians(0.2)))[0].account;
  EXPECT_NEAR(a.albedo() + a.absorbed + a.beyond + a.leaked, 1, 1e-12);
  EXPECT_GT(a.beyond, 1e-4);
  EXPECT_GT(a.absorbed, 0.5);
}

TEST(Goniometer, IsReciprocal) {
  const Cells cells(15_deg);
  const Cell& a = cells[cells.find(direction(radians(0.3), radians(0.2)))];
  const Cell& b = cells[cells.find(direction(radians(1.2), radians(2.6)))];
  for (const Simulation& s : {mirrors(0.5, 60000), lambert_grooves(0.6, 0.9, 60000)}) {
    const Exchange e = measure_exchange(s, a, b);
    const double error = std::hypot(e.forward.standard_error, e.backward.standard_error);
    EXPECT_LT(error, 0.07 * e.forward.mean);
    EXPECT_LT(std::abs(e.forward.mean - e.backward.mean), 4 * error);
  }
}

// Rays from the light, counted per cell, against rays from the viewer that sample the light. The two
// estimators share only the tracer.
TEST(Goniometer, BothEstimatorsAgree) {
  const Simulation s = lambert_grooves(0.5, 0.8, 30000);
  const Cells cells(10_deg);
  const Incidence from{radians(0.9), {}};
  const Scatter scatter = measure_scatter(s, {from}, cells)[0];
  std::vector<Incidence> views;
  std::vector<int> at;
  for (int k = 0; k < cells.size(); k += 29) {
    views.push_back({cells[k].centre_theta(), cells[k].centre_phi()});
    at.push_back(k);
  }
  const auto radiance = measure_radiance(s, {from}, views)[0];
  for (std::size_t k = 0; k < views.size(); ++k) {
    for (int order = 0; order < 2; ++order) {
      const Estimate a = scatter.f[order][at[k]], b = radiance[k].f[order];
      // The mean over a cell differs from the value at its centre: 2 % of the whole are allowed for
      // curvature.
      const double error = 4 * std::hypot(a.standard_error, b.standard_error) + 0.02 * radiance[k].total.mean;
      EXPECT_NEAR(a.mean, b.mean, error)
          << views[k].theta.degrees() << ' ' << views[k].phi.degrees() << " order " << order + 1;
    }
  }
}

TEST(Goniometer, IsTheSameForAnyNumberOfThreads) {
  std::vector<double> first;
  for (const int threads : {1, 2, 3}) {
    Simulation s = mirrors(0.4, 4000);
    s.facets.eta = 1.7;
    s.threads = threads;
    const Scatter scatter = measure_scatter(s, {{radians(1.0), {}}}, Cells(radians(0.1)))[0];
    std::vector<double> values;
    for (const Estimate& e : scatter.total) values.insert(values.end(), {e.mean, e.standard_error});
    if (threads == 1) first = values;
    EXPECT_EQ(values, first) << threads;
  }
  EXPECT_GT(std::accumulate(first.begin(), first.end(), 0.0), 0);
}

TEST(Goniometer, AnotherSeedIsAnotherSurface) {
  Simulation s = mirrors(0.4, 4000);
  const double one = measure_scatter(s, {{radians(1.0), {}}}, Cells(radians(0.3)))[0].total[5].mean;
  s.seed = 2;
  EXPECT_NE(measure_scatter(s, {{radians(1.0), {}}}, Cells(radians(0.3)))[0].total[5].mean, one);
}

}  // namespace
}  // namespace brdf::micro
